// Tells passes/uniforms.glsl of a fragment shader what it reads. Included where `frame` and, but for MATERIAL_LIST, `material` are known.
#include "light/light_block.glsl"
#define FLAT_OUT
#include "passes/flat_uniforms.glsl"

void tellUniforms()
{
#ifdef LIT
    flatEye = vec4(frame.towardsEye, frame.eyeWeight);
#endif
#ifdef ENVIRONMENT_LIGHT
    flatEnvironmentX = vec4(frame.environmentFromWorld[0], frame.environmentIntensity);
    flatEnvironmentY = vec4(frame.environmentFromWorld[1], frame.environmentLastLevel);
    flatEnvironmentZ = frame.environmentFromWorld[2];
#endif
#ifdef PUNCTUAL_LIGHTS
    flatLightDirection = lights[0].direction;
    flatLightIntensity = lights[0].intensity;
#endif
#ifdef PIXEL_RAYS
    flatCorner = frame.corner;
    flatAcross = frame.across;
    flatDown = frame.down;
#endif
#ifndef MATERIAL_LIST
    flatBaseColor = material.baseColorFactor;
    flatEmissive = vec4(material.emissiveFactor, material.normalScale);
    flatScalars = vec4(material.metallicFactor, material.roughnessFactor, material.occlusionStrength, material.ior);
#ifdef PIXEL_RAYS
    flatLevels = material.levels;
    flatOcclusionLevel = material.occlusionLevel;
#endif
#endif
}
