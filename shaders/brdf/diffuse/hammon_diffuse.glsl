// Hammon 2017, PBR Diffuse Lighting for GGX+Smith Microsurfaces, code on the slide "diffuse". 1 - (1 - c)^5 = c (5 - 10 c + 10 c^2 - 5 c^3 +
// c^4), which keeps its bits at grazing. The guard holds where both cosines, and so NoH, vanish.
#include "shared/constants.h"

vec3 Fd_hammon_diffuse(float NoV, float NoL, float VoL, float NoH, float VoH, float alpha, float perceptualRoughness, vec3 baseColor)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return vec3(0.0);
    float facing = VoH * VoH;
    float rough = facing * (0.9 - 0.4 * facing) * ((0.5 + NoH) / (NoH + kLeastDenominator));
    float light = NoL * (5.0 + NoL * (-10.0 + NoL * (10.0 + NoL * (-5.0 + NoL))));
    float view = NoV * (5.0 + NoV * (-10.0 + NoV * (10.0 + NoV * (-5.0 + NoV))));
    float single = mix(1.05 * light * view, rough, alpha) / PI;
    return baseColor * (single + baseColor * (0.1159 * alpha));
}
