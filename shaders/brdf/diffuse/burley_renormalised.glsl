// Lagarde & de Rousiers 2014, listing 4: F_D90 = r (1/2 + 2 VoH^2), the whole scaled from 1 at r = 0 to 1/1.51 at r = 1.
#include "shared/constants.h"

vec3 Fd_burley_renormalised(float NoV, float NoL, float VoL, float NoH, float VoH, float alpha, float perceptualRoughness, vec3 baseColor)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return vec3(0.0);
    float r = perceptualRoughness;
    float grazing = r * (2.0 * VoH * VoH + 0.5) - 1.0; // F_D90 - 1
    float light = 1.0 - NoL;
    float view = 1.0 - NoV;
    float light2 = light * light;
    float view2 = view * view;
    float gain = (1.0 + grazing * (light2 * light2 * light)) * (1.0 + grazing * (view2 * view2 * view));
    const float kRoughScale = 0.662251655629; // 1/1.51
    return baseColor * (gain * mix(1.0, kRoughScale, r) / PI);
}
