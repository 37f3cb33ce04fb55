// Khronos PBR Neutral Tone Mapper, specification 1.0. In [0, 1]. What a dielectric reflects at normal incidence (0.04) is taken away, and the
// peak above 0.8 - 0.04 is compressed towards 1 and loses its saturation.
#include "image/admitted.glsl"

vec3 tone_khronos_neutral(vec3 color)
{
    const float reflected = 0.04, start = 0.8 - reflected, desaturation = 0.15, room = 1.0 - start;
    vec3 c = admitted(color);
    float least = min(c.r, min(c.g, c.b));
    c -= least > 2.0 * reflected ? reflected : least * (1.0 - least / (4.0 * reflected));
    float peak = max(c.r, max(c.g, c.b));
    if (peak <= start)
        return c;
    float compressed = 1.0 - room * room / (peak - start + room);
    float saturation = 1.0 / (1.0 + desaturation * (peak - compressed));
    return mix(vec3(compressed), c * (compressed / peak), saturation);
}
