// Kulla & Conty 2017, with F_ms = F^2 EAverage / (1 - F (1 - EAverage)) of Hill 2018, F the mean of Schlick's term. A table's E may pass 1 by
// its rounding: nothing is lost then. The guard holds for a mirror;
// as a sum it could be reassociated away.
#include "shared/constants.h"

vec3 M_kulla_conty(vec3 single, vec3 spread, vec3 f0, float bias, float E, float ELight, float EAverage)
{
    vec3 F = f0 + (1.0 - f0) * (1.0 / 21.0);
    float lostAverage = 1.0 - EAverage;
    vec3 Fms = F * F * EAverage / (1.0 - F * lostAverage);
    float lobe = max(1.0 - E, 0.0) * (max(1.0 - ELight, 0.0) / max(lostAverage, kLeastDenominator));
    return single + spread * (Fms * lobe);
}
