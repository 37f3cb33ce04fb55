// Conty & Kulla 2017, sections 2 and 3: D / (4 NoV NoL (1 + Lambda(v) + Lambda(l))), Lambda by the paper's fit.
#include "brdf/charlie.glsl"

float S_charlie(float NoV, float NoL, float NoH, float sin2H, float alpha)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return 0.0;
    float smoothness = (1.0 - alpha) * (1.0 - alpha);
    float masking = 1.0 + charlieLambda(NoV, smoothness) + charlieLambda(NoL, smoothness);
    return charlieDistribution(NoH, sin2H, alpha, 1.0 / (4.0 * (NoV * NoL) * masking + kLeastDenominator));
}
