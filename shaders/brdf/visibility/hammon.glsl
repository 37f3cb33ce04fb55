// Hammon 2017: smith_corr without square roots.
#include "shared/constants.h"

float V_hammon(float NoV, float NoL, float NoH, float VoH, float alpha, float perceptualRoughness)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return 0.0;
    return 0.5 / (mix(2.0 * NoL * NoV, NoL + NoV, alpha) + kLeastDenominator);
}
