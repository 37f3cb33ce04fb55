// Blinn 1977; Walter et al. 2007, eq. 30: (p + 2)/(2 pi) NoH^p with p = 2/a^2 - 2, as exp((1 - a^2)/a^2 log(1 - sin2H)) / (pi a^2),
// the exponent in extended precision.
#include "brdf/extended.glsl"
#include "shared/constants.h"

float D_blinn(float NoH, float sin2H, float alpha)
{
    vec2 a2 = exactProduct(alpha, alpha);
    vec2 halfPower = extendedQuotient(extendedSum(vec2(1.0, 0.0), -a2), a2);
    float peak = 1.0 / (PI * a2.x);
    if (halfPower.x <= 0.0)
        return peak; // alpha = 1: no lobe
    if (sin2H >= 1.0)
        return 0.0;
    vec2 exponent = extendedProduct(halfPower, -extendedLogOneMinus(sin2H));
    if (!(exponent.x < kExponentUnderflow))
        return 0.0;
    return scaledExp(peak, exponent);
}
