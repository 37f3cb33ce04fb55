// Vertices of primitives, to clip space and to what the fragment shader reads.
#include "selected.glsl"
#include "shared/bindings.h"
#include "shared/frame.h"
#include "shared/instance.h"

layout(set = 0, binding = kBindFrame, scalar) readonly buffer FrameBuffer { Frame frame; };
layout(set = 0, binding = kBindInstances, scalar) readonly buffer InstanceBuffer { Instance instances[]; };

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
#ifdef SURFACE_POINTS
    gl_PointSize = 1.0;
#endif
    gl_Position = frame.clipFromEye * vec4(position, 1.0);
}
