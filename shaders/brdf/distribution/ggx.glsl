// Trowbridge & Reitz 1975; Walter et al. 2007, eq. 33. sin2H = |n x t|^2 / |t|^2, t = v + l, keeps the digits that
// 1 - NoH^2 loses where the highlight is.
#include "shared/constants.h"

float D_ggx(float NoH, float sin2H, float alpha, float ToH, float BoH, float alphaT, float alphaB)
{
    float a2 = alpha * alpha;
    float d = sin2H + NoH * NoH * a2;
    return a2 / (PI * d * d);
}
