// Lagarde & de Rousiers 2014, section 3.1.3: F_D90 = r (1/2 + 2 VoH^2), the whole scaled from 1 at r = 0 to 1/1.51 at r = 1.
#include "shared/constants.h"

vec3 Fd_burley_renormalised(float NoV, float NoL, float VoL, float NoH, float VoH, float alpha, float perceptualRoughness, vec3 baseColor)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return vec3(0.0);
    float r = perceptualRoughness;
    float grazing = r * (2.0 * VoH * VoH + 0.5); // F_D90
    // 1 - (1 - c)^5 with its digits: at r = 0 it is all there is, and 1 - 1 would leave none of a grazing cosine.
    float light = NoL * (5.0 - NoL * (10.0 - NoL * (10.0 - NoL * (5.0 - NoL))));
    float view = NoV * (5.0 - NoV * (10.0 - NoV * (10.0 - NoV * (5.0 - NoV))));
    float gain = (light + grazing * (1.0 - light)) * (view + grazing * (1.0 - view));
    const float kRoughScale = 0.662251655629; // 1/1.51
    return baseColor * (gain * mix(1.0, kRoughScale, r) / PI);
}
