// Ashikhmin & Premoze 2007: D / (4 (NoL + NoV - NoL NoV)), with the distribution of Conty & Kulla 2017.
#include "brdf/charlie.glsl"

float S_ashikhmin(float NoV, float NoL, float NoH, float sin2H, float alpha)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return 0.0;
    return charlieDistribution(NoH, sin2H, alpha, 0.25 / (NoL + NoV * (1.0 - NoL)));
}
