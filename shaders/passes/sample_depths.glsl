// Depths at a pixel's centre and at its four samples, for passes/edges.frag and passes/reconstruct.frag.
#include "shared/bindings.h"
#include "shared/constants.h"
#include "shared/frame.h"

layout(set = 0, binding = kBindFrame, scalar) uniform FrameBlock { Frame frame; };
layout(set = 0, binding = kBindDepth) uniform sampler2D depths;          // where colours were shaded; 0: nothing there
layout(set = 0, binding = kBindSampleDepth) uniform sampler2DMS samples; // at Vulkan's standard places

vec4 sampleDepths(ivec2 p)
{
    return vec4(texelFetch(samples, p, 0).r, texelFetch(samples, p, 1).r, texelFetch(samples, p, 2).r, texelFetch(samples, p, 3).r);
}

// By how much depth differs from a surface to one that lies a pixel's width behind it.
float widthInDepth(float z)
{
    vec4 c = frame.viewFromDepth;
    float below = c.z * z + c.w;
    float far = mix((c.x * z + c.y) / below, 1.0, frame.orthographic);
    return length(frame.across) * far * below * below / abs(c.x * c.w - c.y * c.z);
}
