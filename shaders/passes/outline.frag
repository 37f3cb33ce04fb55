// White around what passes/silhouette.frag has marked, nothing elsewhere.
#include "shared/bindings.h"

layout(set = 0, binding = kBindFrame, scalar) uniform SizeBlock { ivec2 last; }; // pixel of the picture: more may lie in memory
layout(set = 0, binding = kBindSource) uniform sampler2D marks;

layout(location = 0) out vec4 outCode;

const int kLineWidth = 2; // pixels
const ivec2 kAround[8] = ivec2[](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1), ivec2(1, 1), ivec2(-1, 1), ivec2(1, -1),
                                 ivec2(-1, -1));

void main()
{
    ivec2 p = ivec2(gl_FragCoord.xy);
    float near = 0.0;
    for (int i = 0; i < 8; ++i)
        near = max(near, texelFetch(marks, clamp(p + kLineWidth * kAround[i], ivec2(0), last), 0).r);
    outCode = vec4(1.0, 1.0, 1.0, near * (1.0 - texelFetch(marks, p, 0).r));
}
