// Beckmann & Spizzichino 1963; Walter et al. 2007, eq. 25: exp(-tan^2/a^2) / (pi a^2 cos^4), the exponent in extended precision.
// Towards NoH = 0 the exponential goes first, so nothing is left of 1/cos^4.
#include "brdf/extended.glsl"
#include "shared/constants.h"

float D_beckmann(float NoH, float sin2H, float alpha, float ToH, float BoH, float alphaT, float alphaB)
{
    vec2 cos2 = exactProduct(NoH, NoH);
    vec2 a2 = exactProduct(alpha, alpha);
    vec2 exponent = extendedQuotient(vec2(sin2H, 0.0), extendedProduct(cos2, a2));
    if (!(exponent.x < kExponentUnderflow))
        return 0.0;
    return scaledExp(1.0 / (PI * a2.x * cos2.x * cos2.x), exponent);
}
