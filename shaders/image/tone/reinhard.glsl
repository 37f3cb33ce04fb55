// Reinhard et al. 2002, eq. 3, per channel. In [0, 1].
#include "image/admitted.glsl"

vec3 tone_reinhard(vec3 color)
{
    return 1.0 - 1.0 / (1.0 + admitted(color));
}
