// Neumann, Neumann & Szirmay-Kalos 1999: G / (NoV NoL) as 1 / max(NoL, NoV).
#include "shared/constants.h"

float V_neumann(float NoV, float NoL, float NoH, float VoH, float alpha, float perceptualRoughness)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return 0.0;
    return 0.25 / (max(NoL, NoV) + kLeastDenominator);
}
