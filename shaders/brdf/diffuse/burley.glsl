// Burley 2012, section 5.3.
#include "shared/constants.h"

vec3 Fd_burley(float NoV, float NoL, float VoL, float NoH, float VoH, float alpha, float perceptualRoughness, vec3 baseColor)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return vec3(0.0);
    float grazing = 2.0 * perceptualRoughness * VoH * VoH - 0.5; // F_D90 - 1
    float light = 1.0 - NoL;
    float view = 1.0 - NoV;
    float light2 = light * light;
    float view2 = view * view;
    float gain = (1.0 + grazing * (light2 * light2 * light)) * (1.0 + grazing * (view2 * view2 * view));
    return baseColor * (gain / PI);
}
