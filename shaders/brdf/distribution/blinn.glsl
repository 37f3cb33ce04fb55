// Blinn 1977; Walter et al. 2007, eq. 30: (p + 2)/(2 pi) NoH^p with p = 2/a^2 - 2, as exp((1 - a^2)/a^2 log(NoH^2)) / (pi a^2), the
// exponent in extended precision. NoH^2 comes from whichever of sin2H and NoH was rounded less in it.
#include "brdf/extended.glsl"
#include "shared/constants.h"

float D_blinn(float NoH, float sin2H, float alpha, float ToH, float BoH, float alphaT, float alphaB)
{
    vec2 a2 = exactProduct(alpha, alpha);
    vec2 halfPower = extendedQuotient(extendedSum(vec2(1.0, 0.0), -a2), a2);
    float peak = 1.0 / (PI * a2.x);
    if (halfPower.x <= 0.0)
        return peak; // alpha = 1: no lobe
    vec2 cos2 = sin2H < 0.5 ? exactSum(1.0, -sin2H) : exactProduct(NoH, NoH);
    if (cos2.x <= 0.0)
        return 0.0;
    vec2 exponent = extendedProduct(halfPower, -extendedLog(cos2));
    if (!(exponent.x < kExponentUnderflow))
        return 0.0;
    return scaledExp(peak, exponent);
}
