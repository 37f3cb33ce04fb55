// Torrance & Sparrow 1967; Cook & Torrance 1982: V-shaped grooves. The lesser cosine is divided out before the least of the terms is taken.
#include "shared/constants.h"

float V_vcavity(float NoV, float NoL, float NoH, float VoH, float alpha, float perceptualRoughness)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return 0.0;
    float unblocked = 0.25 / (NoV * NoL + kLeastDenominator);
    float blocked = 0.5 * NoH / (VoH * max(NoV, NoL) + kLeastDenominator);
    return min(unblocked, blocked);
}
