// Fresnel's equations for the index n + i k, without complex numbers: a + i b is the root of (n + i k)^2 - sin^2 (Born & Wolf, section 14.2).
// The lesser of a and b comes from a b = n k, and a - c from (a - c)(a + c) = b^2 + n^2 - k^2 - 1: no difference of near-equal numbers is
// left. c in [0, 1].
#ifndef TORRANCE_BRDF_CONDUCTOR
#define TORRANCE_BRDF_CONDUCTOR
#include "brdf/extended.glsl"
#include "shared/constants.h"

float conductorReflectance(float c, float n, float k)
{
    float s2 = (1.0 - c) * (1.0 + c);
    float nk = n * k;
    float k2 = k * k;
    float real = squaresLessOne(n, c) - k2;
    float modulus = sqrt(real * real + 4.0 * nk * nk);
    float greater = sqrt(0.5 * (modulus + abs(real)));
    float lesser = min(nk / (greater + kLeastDenominator), greater); // the least: what underflow left of both
    float a = real >= 0.0 ? greater : lesser;
    float b2 = real >= 0.0 ? lesser * lesser : greater * greater;
    float aLessC = (b2 + ((n - 1.0) * (n + 1.0) - k2)) / (a + c + kLeastDenominator);
    float perpendicular = (aLessC * aLessC + b2) / ((a + c) * (a + c) + b2 + kLeastDenominator);
    float toParallel = ((a * c - s2) * (a * c - s2) + b2 * c * c) / ((a * c + s2) * (a * c + s2) + b2 * c * c + kLeastDenominator);
    return 0.5 * perpendicular * (1.0 + toParallel);
}

#endif
