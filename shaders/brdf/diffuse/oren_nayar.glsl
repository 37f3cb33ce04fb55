// Oren & Nayar 1994, the qualitative model, sigma = perceptualRoughness in radians: cos(phi) sin(alpha) tan(beta) = (VoL - NoV NoL) / max(NoV, NoL).
#include "shared/constants.h"

vec3 Fd_oren_nayar(float NoV, float NoL, float VoL, float NoH, float VoH, float alpha, float perceptualRoughness, vec3 baseColor)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return vec3(0.0);
    float variance = perceptualRoughness * perceptualRoughness;
    float A = (0.5 * variance + 0.33) / (variance + 0.33);
    float B = 0.45 * variance / (variance + 0.09);
    float s = VoL - NoV * NoL;
    return baseColor * ((s > 0.0 ? A + B * s / max(NoV, NoL) : A) / PI);
}
