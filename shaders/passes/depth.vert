// Vertices of primitives to clip space, as passes/surface.vert takes them there: where a surface is drawn a second time, its depth must be
// equal to the bit.
#include "shared/bindings.h"
#include "shared/frame.h"
#include "shared/instance_attributes.h"

layout(set = 0, binding = kBindFrame, scalar) uniform FrameBlock { Frame frame; };

layout(location = 0) in vec3 inPosition;
layout(location = kInstanceLinear) in mat3 inLinear;
layout(location = kInstanceTranslation) in vec3 inTranslation;
invariant gl_Position;

void main()
{
    vec3 position = inLinear * inPosition + inTranslation;
    gl_PointSize = 1.0;
    gl_Position = frame.clipFromEye * vec4(position, 1.0);
}
