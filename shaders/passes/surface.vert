// Vertices of primitives, to clip space and to what the fragment shader reads.
#include "selected.glsl"
#include "shared/bindings.h"
#include "shared/frame.h"
#include "shared/instance.h"
#include "shared/material.h"
#include "material/uv.glsl"

layout(set = 0, binding = kBindFrame, scalar) readonly buffer FrameBuffer { Frame frame; };
layout(set = 0, binding = kBindInstances, scalar) readonly buffer InstanceBuffer { Instance instances[]; };
layout(set = 0, binding = kBindMaterials, scalar) readonly buffer MaterialBuffer { Material materials[]; };

layout(location = 0) in vec3 inPosition;
layout(location = 0) out vec3 outPosition;
layout(location = 6) flat out uvec2 outIds; // material, object
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
#ifdef METALLIC_ROUGHNESS_UV_SOURCE
layout(location = 8) out vec2 outMetallicRoughnessUv;
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

void main()
{
    Instance instance = instances[gl_InstanceIndex];
    vec3 position = instance.linear * inPosition + instance.translation;
    outPosition = position;
    outIds = uvec2(instance.material, instance.object);
#ifdef NORMALS
    outNormal = instance.normal * inNormal;
#endif
#ifdef TANGENTS
    outTangent = vec4(instance.linear * inTangent.xyz, inTangent.w * instance.handedness);
#endif
#ifdef UV0
    outUv0 = inUv0;
#endif
#ifdef UV1
    outUv1 = inUv1;
#endif
#ifdef COLORS
    outColor = inColor;
#endif
#ifdef BASE_COLOR_UV_SOURCE
    outBaseColorUv = transformUv(materials[instance.material].baseColorUv, BASE_COLOR_UV_SOURCE);
#endif
#ifdef METALLIC_ROUGHNESS_UV_SOURCE
    outMetallicRoughnessUv = transformUv(materials[instance.material].metallicRoughnessUv, METALLIC_ROUGHNESS_UV_SOURCE);
#endif
#ifdef NORMAL_UV_SOURCE
    outNormalUv = transformUv(materials[instance.material].normalUv, NORMAL_UV_SOURCE);
#endif
#ifdef OCCLUSION_UV_SOURCE
    outOcclusionUv = transformUv(materials[instance.material].occlusionUv, OCCLUSION_UV_SOURCE);
#endif
#ifdef EMISSIVE_UV_SOURCE
    outEmissiveUv = transformUv(materials[instance.material].emissiveUv, EMISSIVE_UV_SOURCE);
#endif
#ifdef SURFACE_POINTS
    gl_PointSize = 1.0;
#endif
    gl_Position = frame.clipFromEye * vec4(position, 1.0);
}
