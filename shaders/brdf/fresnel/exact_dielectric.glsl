// Walter et al. 2007, eq. 22, with g - c = (n^2 - 1)/(g + c), so that index 1 gives exactly 0; g^2 in extended precision, because its
// root magnifies what is lost near the critical angle. Index 0 means infinite; above 1e9 F = 1 - 4/n rounds to 1, and n^2 would overflow.
#include "brdf/extended.glsl"
#include "shared/constants.h"

vec3 F_exact_dielectric(float VoH, float oneLessVoH, vec3 f0, vec3 f90, float ior, vec3 eta, vec3 k, vec3 f82)
{
    const float kInfiniteIor = 1e9;
    if (ior == 0.0 || ior > kInfiniteIor)
        return vec3(1.0);
    float c = clamp(VoH, 0.0, 1.0);
    float m = (ior - 1.0) * (ior + 1.0);
    float g2 = squaresLessOne(ior, c);
    if (g2 < 0.0)
        return vec3(1.0); // beyond the critical angle
    float sum = sqrt(g2) + c;
    float A = m / (sum * sum + kLeastDenominator);
    float B = (c * sum - 1.0) / (c * m / (sum + kLeastDenominator) + 1.0);
    return vec3(0.5 * A * A * (1.0 + B * B));
}
