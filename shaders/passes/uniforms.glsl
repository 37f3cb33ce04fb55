// The frame and the material that a fragment shader reads: the blocks themselves, or what the vertex shader tells of them with the rest
// from the blocks. main() begins with readUniforms(). With MATERIAL_LIST there is no `material`: the includer knows which it is.
#include "shared/bindings.h"
#include "shared/frame.h"
#include "shared/material.h"

#ifdef FLAT_UNIFORMS

#include "passes/flat_uniforms.glsl"

layout(set = 0, binding = kBindFrame, scalar) uniform FrameBlock { Frame frameBlock; };
Frame frame;
#ifndef MATERIAL_LIST
layout(set = 0, binding = kBindMaterial, scalar) uniform MaterialBlock { Material materialBlock; };
Material material;
#endif

void readUniforms()
{
    frame = frameBlock;
#ifdef LIT
    frame.towardsEye = flatEye.xyz;
    frame.eyeWeight = flatEye.w;
#endif
#ifdef ENVIRONMENT_LIGHT
    frame.environmentFromWorld = mat3(flatEnvironmentX.xyz, flatEnvironmentY.xyz, flatEnvironmentZ);
    frame.environmentIntensity = flatEnvironmentX.w;
    frame.environmentLastLevel = flatEnvironmentY.w;
#endif
#ifdef PIXEL_RAYS
    frame.corner = flatCorner;
    frame.across = flatAcross;
    frame.down = flatDown;
#endif
#ifndef MATERIAL_LIST
    material = materialBlock;
    material.baseColorFactor = flatBaseColor;
    material.emissiveFactor = flatEmissive.xyz;
    material.normalScale = flatEmissive.w;
    material.metallicFactor = flatScalars.x;
    material.roughnessFactor = flatScalars.y;
    material.occlusionStrength = flatScalars.z;
    material.ior = flatScalars.w;
#ifdef PIXEL_RAYS
    material.levels = flatLevels;
    material.occlusionLevel = flatOcclusionLevel;
#endif
#endif
}

#else

layout(set = 0, binding = kBindFrame, scalar) uniform FrameBlock { Frame frame; };
#ifndef MATERIAL_LIST
layout(set = 0, binding = kBindMaterial, scalar) uniform MaterialBlock { Material material; };
#endif

void readUniforms() {}

#endif
