// Fujii, A tiny improvement of Oren-Nayar reflectance model: the lobe that EON starts from, whose lost light nothing makes up for.
#include "brdf/eon.glsl"

vec3 Fd_fujii(float NoV, float NoL, float VoL, float NoH, float VoH, float alpha, float perceptualRoughness, vec3 baseColor)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return vec3(0.0);
    return baseColor * (fujiiLobe(NoV, NoL, VoL, VoH, perceptualRoughness) / (PI * (1.0 + kEonGrazing * perceptualRoughness)));
}
