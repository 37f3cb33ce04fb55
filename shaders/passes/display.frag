// A picture as the window shows it: what src/image/display.h does for files, then over a chequerboard where nothing covers a pixel.
// selected.glsl defines TONE and TRANSFER.
#include "shared/bindings.h"
#include "shared/display.h"
#include "selected.glsl"

layout(set = 0, binding = kBindFrame, scalar) uniform DisplayBlock { Display display; };
layout(set = 0, binding = kBindSource) uniform sampler2D source;

layout(location = 0) out vec4 outCode;

const float kDarkCheck = 0.35, kLightCheck = 0.45; // codes
const float kMostCode = 255.0;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy) - display.origin;
    vec4 drawn = texelFetch(source, pixel, 0);
    float coverage = min(drawn.a, 1.0);
    vec3 straight = coverage > 0.0 ? drawn.rgb / coverage : vec3(0.0);
    vec3 codes = clamp(TRANSFER(TONE(straight * display.gain + display.shift)), 0.0, 1.0);
    ivec2 square = pixel / int(kCheckPixels);
    float check = ((square.x + square.y) & 1) == 0 ? kDarkCheck : kLightCheck;
    // Rounded here: a device may take either of the two nearest codes (Vulkan 1.3, section 3.9.2), and on a real GPU up to 3 % were not a file's.
    outCode = vec4(floor(mix(vec3(check), codes, coverage) * kMostCode + 0.5) / kMostCode, 1.0);
}
