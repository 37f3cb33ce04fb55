// Portsmouth, Kutz & Hill 2025, with the exact albedo.
#include "brdf/eon.glsl"

vec3 Fd_eon(float NoV, float NoL, float VoL, float NoH, float VoH, float alpha, float perceptualRoughness, vec3 baseColor)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return vec3(0.0);
    return eonLobes(NoV, NoL, VoL, VoH, perceptualRoughness, baseColor, eonLostExact(NoV), eonLostExact(NoL));
}
