// What several source systems share, in forms that keep their digits.
#ifndef TORRANCE_MATERIAL_MODEL_PARTS
#define TORRANCE_MATERIAL_MODEL_PARTS

#include "shared/constants.h"

// Schlick's F = F0 + (1 - F0) x^5 and 1 - F = (1 - F0)(1 - x^5), x = 1 - v.h, F0 = mix(f0, metal, metallic): a bright metal's 1 - F has
// no digits left in F.
struct Fresnel
{
    vec3 f0;
    vec3 reflected;
    vec3 transmitted;
};

Fresnel schlickMix(float f0, vec3 metal, float metallic, float VoH, float oneLessVoH)
{
    float x2 = oneLessVoH * oneLessVoH;
    vec3 rest = (1.0 - f0) * (1.0 - metallic) + (1.0 - metal) * metallic; // 1 - F0
    Fresnel F;
    F.f0 = f0 * (1.0 - metallic) + metal * metallic;
    F.reflected = F.f0 + rest * (x2 * x2 * oneLessVoH);
    F.transmitted = rest * (VoH * (1.0 + oneLessVoH + x2 * (1.0 + oneLessVoH + x2)));
    return F;
}

// Schlick's G1(x) / x: G over 4 NoV NoL is a product of two, over 4.
float schlickMaskingOver(float x, float k)
{
    return 1.0 / (x + k * (1.0 - x));
}

// GGX's n.h^2 (a^2 - 1) + 1 = a^2 + (1 - a^2) sin^2: nothing cancels, and at grazing, where n.h is a quotient of small numbers, it is
// not needed.
float trowbridgeReitzBase(float sin2H, float a2)
{
    return a2 + (1.0 - a2) * sin2H;
}

float trowbridgeReitz(float sin2H, float alpha)
{
    float a2 = alpha * alpha;
    float d = trowbridgeReitzBase(sin2H, a2);
    return a2 / (PI * d * d);
}

// min(1, 2 NoH NoV / VoH, 2 NoH NoL / VoH) / (NoV NoL): the lesser cosine goes out of the second and third.
float grooveAttenuationOver(float NoV, float NoL, float NoH, float VoH)
{
    return min(1.0 / (NoV * NoL + kLeastDenominator), 2.0 * NoH / (VoH * max(NoV, NoL) + kLeastDenominator));
}

vec3 blended(vec3 a, vec3 b, float t)
{
    return a * (1.0 - t) + b * t;
}

#endif
