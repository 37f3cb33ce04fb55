// Portsmouth, Kutz & Hill 2025, with the quartic fit of the albedo. Held at zero: within 0.09 degrees of grazing the fit can make it
// negative by 1e-4 of a Lambert.
#include "brdf/eon.glsl"

vec3 Fd_eon_approx(float NoV, float NoL, float VoL, float NoH, float VoH, float alpha, float perceptualRoughness, vec3 baseColor)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return vec3(0.0);
    return max(eonLobes(NoV, NoL, VoL, VoH, perceptualRoughness, baseColor, eonLostFitted(NoV), eonLostFitted(NoL)), vec3(0.0));
}
