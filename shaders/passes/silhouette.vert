// Vertices of one primitive to clip space.
#include "shared/bindings.h"

layout(set = 0, binding = kBindFrame, scalar) uniform PlaceBlock { mat4 clipFromObject; };

layout(location = 0) in vec3 position;

void main()
{
    gl_PointSize = 1.0;
    gl_Position = clipFromObject * vec4(position, 1.0);
}
