// One of N pictures; the blending weighs it and adds it to their sum, so that the shader is the same for every N.
#include "shared/bindings.h"

layout(set = 0, binding = kBindSource) uniform sampler2D source;

layout(location = 0) out vec4 outColor;

void main()
{
    outColor = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
}
