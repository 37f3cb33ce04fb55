// Where nothing was drawn: the panorama, or with BLURRED a level of its prefiltered chain.
#include "selected.glsl"
#include "shared/bindings.h"
#include "shared/frame.h"
#include "environment/panorama.glsl"

layout(set = 0, binding = kBindFrame, scalar) uniform FrameBlock { Frame frame; };
#ifdef BLURRED
layout(set = 0, binding = kBindBackground) uniform samplerCube chain;
#else
layout(set = 0, binding = kBindPanorama) uniform sampler2D panorama;
#endif

layout(location = 0) out vec4 outColor;

void main()
{
    vec3 q = frame.corner + gl_FragCoord.x * frame.across + gl_FragCoord.y * frame.down;
    vec3 direction = frame.environmentFromWorld * mix(q, frame.forward, frame.orthographic);
#ifdef BLURRED
    vec3 radiance = textureLod(chain, direction, frame.panoramaLevel).rgb;
#else
    // The level is given, not derived: derivatives break at the seam where u goes from 1 to 0.
    vec3 radiance = textureLod(panorama, panoramaUv(direction), frame.panoramaLevel).rgb;
#endif
    outColor = vec4(radiance * frame.environmentIntensity, 1.0);
}
