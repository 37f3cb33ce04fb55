// Chan 2018, Material Advances in Call of Duty: WWII. The gloss g of alpha^2 = 2 / (1 + 2^(18 g)) is held within [0, 1]; the sum, which g in (0.71, 1) can make
// negative at grazing, at zero.
#include "shared/constants.h"

vec3 Fd_chan(float NoV, float NoL, float VoL, float NoH, float VoH, float alpha, float perceptualRoughness, vec3 baseColor)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return vec3(0.0);
    float a2 = alpha * alpha;
    float g = clamp(log2(2.0 / a2 - 1.0) / 18.0, 0.0, 1.0);
    float facing = 1.0 - VoH;
    float light = 1.0 - NoL;
    float view = 1.0 - NoV;
    float facing2 = facing * facing;
    float light2 = light * light;
    float view2 = view * view;
    float rough = VoH + facing2 * facing2 * facing;
    float smoothBody = (1.0 - 0.75 * view2 * view2 * view) * (1.0 - 0.75 * light2 * light2 * light);
    float bump = ((34.5 * g - 59.0) * g + 24.5) * VoH * exp2(-max(73.2 * g - 21.2, 8.9) * sqrt(NoH));
    return baseColor * (max(mix(rough, smoothBody, clamp(2.2 * g - 0.5, 0.0, 1.0)) + bump, 0.0) / PI);
}
