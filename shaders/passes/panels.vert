// Triangles of the window's panels, in its coordinates.
#include "shared/bindings.h"

layout(set = 0, binding = kBindFrame, scalar) uniform PlaceBlock
{
    vec2 scale; // clip = scale * position + origin
    vec2 origin;
};

layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;

layout(location = 0) out vec2 outUv;
layout(location = 1) out vec4 outColor;

void main()
{
    outUv = uv;
    outColor = color;
    gl_Position = vec4(scale * position + origin, 0.0, 1.0);
}
