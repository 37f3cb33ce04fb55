// Codes with straight alpha, from a picture and a colour; blended premultiplied.
#include "shared/bindings.h"

layout(set = 0, binding = kBindSource) uniform sampler2D source;

layout(location = 0) in vec2 uv;
layout(location = 1) in vec4 color;

layout(location = 0) out vec4 outCode;

void main()
{
    vec4 code = color * texture(source, uv);
    outCode = vec4(code.rgb * code.a, code.a);
}
