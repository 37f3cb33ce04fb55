// What passes/surface.vert and its kin do.
#include "selected.glsl"
#include "shared/bindings.h"
#include "shared/frame.h"
#include "shared/instance_attributes.h"
#include "shared/material.h"
#include "material/uv.glsl"

layout(set = 0, binding = kBindFrame, scalar) uniform FrameBlock { Frame frame; };
layout(set = 0, binding = kBindMaterial, scalar) uniform MaterialBlock { Material material; };

layout(location = 0) in vec3 inPosition;
layout(location = 0) out vec3 outPosition;
layout(location = kInstanceLinear) in mat3 inLinear;
layout(location = kInstanceTranslation) in vec3 inTranslation;
#ifdef IDS
layout(location = kInstanceIds) in uvec2 inIds;
layout(location = 12) flat out uvec2 outIds;
#endif
#if defined(NORMALS) || defined(TANGENTS)
layout(location = kInstanceNormal) in vec3 inNormalX;
layout(location = kInstanceNormal + 1) in vec3 inNormalY;
layout(location = kInstanceNormal + 2) in vec4 inNormalZHandedness;
#endif
#ifdef NORMALS
layout(location = 1) in vec3 inNormal;
layout(location = 1) out vec3 outNormal;
#endif
#ifdef TANGENTS
layout(location = 2) in vec4 inTangent;
layout(location = 2) out vec4 outTangent;
#endif
#ifdef UV0
layout(location = 3) in vec2 inUv0;
layout(location = 3) out vec2 outUv0;
#endif
#ifdef UV1
layout(location = 4) in vec2 inUv1;
layout(location = 4) out vec2 outUv1;
#endif
#ifdef COLORS
layout(location = 5) in vec4 inColor;
layout(location = 5) out vec4 outColor;
#endif

// KHR_texture_transform is applied here and interpolated: lavapipe's helper invocations read zeros from storage buffers, so
// that coordinates made from a material in the fragment shader would have wrong derivatives at the edges of triangles.
#ifdef BASE_COLOR_UV_SOURCE
layout(location = 7) out vec2 outBaseColorUv;
#endif
#ifdef MATERIAL_UV_SOURCE
layout(location = 8) out vec2 outMaterialUv;
#endif
#ifdef NORMAL_UV_SOURCE
layout(location = 9) out vec2 outNormalUv;
#endif
#ifdef OCCLUSION_UV_SOURCE
layout(location = 10) out vec2 outOcclusionUv;
#endif
#ifdef EMISSIVE_UV_SOURCE
layout(location = 11) out vec2 outEmissiveUv;
#endif

#ifdef FLAT_UNIFORMS
#include "passes/uniforms_out.glsl"
#endif

invariant gl_Position; // as passes/depth.vert has it

void main()
{
    vec3 position = inLinear * inPosition + inTranslation;
    outPosition = position;
#ifdef IDS
    outIds = inIds;
#endif
#ifdef NORMALS
    outNormal = mat3(inNormalX, inNormalY, inNormalZHandedness.xyz) * inNormal;
#endif
#ifdef TANGENTS
    outTangent = vec4(inLinear * inTangent.xyz, inTangent.w * inNormalZHandedness.w);
#endif
#ifdef UV0
#ifdef ONE_PLACE
    outUv0 = transformUv(material.placeUv, inUv0);
#else
    outUv0 = inUv0;
#endif
#endif
#ifdef UV1
    outUv1 = inUv1;
#endif
#ifdef COLORS
    outColor = inColor;
#endif
#ifdef BASE_COLOR_UV_SOURCE
    outBaseColorUv = transformUv(material.baseColorUv, BASE_COLOR_UV_SOURCE);
#endif
#ifdef MATERIAL_UV_SOURCE
    outMaterialUv = transformUv(material.materialUv, MATERIAL_UV_SOURCE);
#endif
#ifdef NORMAL_UV_SOURCE
    outNormalUv = transformUv(material.normalUv, NORMAL_UV_SOURCE);
#endif
#ifdef OCCLUSION_UV_SOURCE
    outOcclusionUv = transformUv(material.occlusionUv, OCCLUSION_UV_SOURCE);
#endif
#ifdef EMISSIVE_UV_SOURCE
    outEmissiveUv = transformUv(material.emissiveUv, EMISSIVE_UV_SOURCE);
#endif
#ifdef FLAT_UNIFORMS
    tellUniforms();
#endif
#ifdef SURFACE_POINTS
    gl_PointSize = 1.0;
#endif
    gl_Position = frame.clipFromEye * vec4(position, 1.0);
}
