// Fresnel's equations for the index eta + i k, without complex numbers: a + i b is the root of (eta + i k)^2 - sin^2 (Born & Wolf,
// section 14.2). The lesser of a and b comes from a b = eta k, and a - c from (a - c)(a + c) = b^2 + eta^2 - k^2 - 1: no difference
// of near-equal numbers is left.
#include "brdf/extended.glsl"
#include "shared/constants.h"

vec3 F_exact_conductor(float VoH, float oneLessVoH, vec3 f0, vec3 f90, float ior, vec3 eta, vec3 k)
{
    float c = clamp(VoH, 0.0, 1.0);
    float s2 = (1.0 - c) * (1.0 + c);
    vec3 reflected;
    for (int channel = 0; channel < 3; ++channel) {
        float n = eta[channel];
        float nk = n * k[channel];
        float k2 = k[channel] * k[channel];
        float real = squaresLessOne(n, c) - k2;
        float modulus = sqrt(real * real + 4.0 * nk * nk);
        float greater = sqrt(0.5 * (modulus + abs(real)));
        float lesser = min(nk / (greater + kLeastDenominator), greater); // the least: what underflow left of both
        float a = real >= 0.0 ? greater : lesser;
        float b2 = real >= 0.0 ? lesser * lesser : greater * greater;
        float aLessC = (b2 + ((n - 1.0) * (n + 1.0) - k2)) / (a + c + kLeastDenominator);
        float perpendicular = (aLessC * aLessC + b2) / ((a + c) * (a + c) + b2 + kLeastDenominator);
        float toParallel = ((a * c - s2) * (a * c - s2) + b2 * c * c) / ((a * c + s2) * (a * c + s2) + b2 * c * c + kLeastDenominator);
        reflected[channel] = 0.5 * perpendicular * (1.0 + toParallel);
    }
    return reflected;
}
