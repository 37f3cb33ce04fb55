// Adds one of N pictures, weighted, to their sum.
#include "shared/bindings.h"

layout(constant_id = 0) const float kWeight = 1.0;

layout(set = 0, binding = kBindSource) uniform sampler2D source;

layout(location = 0) out vec4 outColor;

void main()
{
    outColor = kWeight * texelFetch(source, ivec2(gl_FragCoord.xy), 0);
}
