// The usual transcription of Walter et al. 2007, eq. 33, kept to be charted: the sum cancels to the last bits of NoH near the mirror
// direction, and to nothing there for alpha < 2.4e-4, where the guard keeps the quotient finite.
#include "shared/constants.h"

float D_ggx_textbook(float NoH, float sin2H, float alpha, float ToH, float BoH, float alphaT, float alphaB)
{
    float a2 = alpha * alpha;
    float d = NoH * NoH * (a2 - 1.0) + 1.0;
    return a2 / (PI * d * d + kLeastDenominator);
}
