// Stephen Hill's fit of the ACES reference and output transforms, with both of its matrices: BakingLab, ACES.hlsl, 2016. In [0, 1].
#include "image/admitted.glsl"

vec3 tone_aces_hill(vec3 color)
{
    // By columns.
    const mat3 toFit = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
    const mat3 fromFit = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
    vec3 v = toFit * admitted(color);
    // Divided by v on both sides where it is large: its square would leave 32 bits.
    vec3 w = max(v, 1.0);
    vec3 fitted = (v / w * (v + 0.0245786) - 0.000090537 / w) / (v / w * (0.983729 * v + 0.4329510) + 0.238081 / w);
    return clamp(fromFit * fitted, 0.0, 1.0);
}
