// Krzysztof Narkowicz's rational fit of ACES per channel: ACES Filmic Tone Mapping Curve, 2015. In [0, 1].
#include "image/admitted.glsl"

vec3 tone_aces_narkowicz(vec3 color)
{
    vec3 c = admitted(color);
    vec3 w = max(c, 1.0); // both sides are divided by it: the square of a large c would leave 32 bits
    return clamp(c / w * (2.51 * c + 0.03) / (c / w * (2.43 * c + 0.59) + 0.14 / w), 0.0, 1.0);
}
