// Burley 2012, eq. 13, with the quotients by alphaT and alphaB multiplied out: |(aB ToH, aT BoH, aT aB NoH)|^2 is a sum of squares, at least
// (kMinAlpha^2)^2 = 1e-16.
#include "shared/constants.h"

float D_ggx_aniso(float NoH, float sin2H, float alpha, float ToH, float BoH, float alphaT, float alphaB)
{
    float a2 = alphaT * alphaB;
    vec3 x = vec3(alphaB * ToH, alphaT * BoH, a2 * NoH);
    float w = a2 / dot(x, x);
    return a2 * w * w / PI;
}
