// Kelemen & Szirmay-Kalos 2001: G / (NoV NoL) as 1 / VoH^2.
#include "shared/constants.h"

float V_kelemen(float NoV, float NoL, float NoH, float VoH, float alpha, float perceptualRoughness)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return 0.0;
    return 1.0 / (4.0 * VoH * VoH + kLeastDenominator);
}
