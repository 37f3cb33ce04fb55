// Heitz 2014, eqs. 72 and 99: height-correlated Smith for GGX. glTF 2.0, Appendix B.
#include "shared/constants.h"

float V_smith_corr(float NoV, float NoL, float NoH, float VoH, float alpha, float perceptualRoughness)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return 0.0;
    float a2 = alpha * alpha;
    float view = NoL * sqrt(a2 + (1.0 - a2) * NoV * NoV);
    float light = NoV * sqrt(a2 + (1.0 - a2) * NoL * NoL);
    return 0.5 / (view + light + kLeastDenominator);
}
