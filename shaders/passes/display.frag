// A picture as the window shows it: what src/image/display.h does for files, then over a chequerboard where nothing covers a pixel.
// selected.glsl defines TONE and TRANSFER.
#include "shared/bindings.h"
#include "shared/display.h"
#include "selected.glsl"

layout(set = 0, binding = kBindFrame, scalar) uniform DisplayBlock { Display display; };
layout(set = 0, binding = kBindSource) uniform sampler2D source;

layout(location = 0) out vec4 outCode;

const float kDarkCheck = 0.35, kLightCheck = 0.45; // codes

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy) - display.origin;
    vec4 drawn = texelFetch(source, pixel, 0);
    float coverage = min(drawn.a, 1.0);
    vec3 straight = coverage > 0.0 ? drawn.rgb / coverage : vec3(0.0);
    vec3 codes = clamp(TRANSFER(TONE(straight * display.gain + display.shift)), 0.0, 1.0);
    ivec2 square = pixel / int(kCheckPixels);
    float check = ((square.x + square.y) & 1) == 0 ? kDarkCheck : kLightCheck;
    outCode = vec4(mix(vec3(check), codes, coverage), 1.0);
}
