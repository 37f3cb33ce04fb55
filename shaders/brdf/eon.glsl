// What the two forms of EON share (Portsmouth, Kutz & Hill, EON: A Practical Energy-Preserving Rough Diffuse BRDF, 2025).
#ifndef TORRANCE_BRDF_EON
#define TORRANCE_BRDF_EON
#include "shared/constants.h"

const float kEonGrazing = 0.287793409210806; // 1/2 - 2/(3 pi): the albedo's shape G/pi at grazing
const float kEonMean = 0.0724882124569241;   // 2/3 - 28/(15 pi): its cosine-weighted mean

// atan(y), 0 <= y <= 1, within 2e-8 of itself: Chebyshev fit of atan(y)/y in y^2. The built-in one may be off by 4096 units.
float arcTangent(float y)
{
    float x = y * y;
    return y *
           (0.999999981789 +
            x * (-0.333330367093 +
                 x * (0.199918720291 +
                      x * (-0.141977977941 +
                           x * (0.10618370637 +
                                x * (-0.07456854826 + x * (0.0421376235892 + x * (-0.0157312491222 + x * 0.00276628350176))))))));
}

// kEonGrazing - G/pi for the exact albedo: the share lost at this cosine is A r times it. At grazing both terms are nearly the same, so
// with the angle from the horizon e = asin(c) = 2 atan(c / (1 + s)) the difference is rearranged to terms that vanish with c.
float eonLostExact(float cosine)
{
    float c = min(cosine, 1.0);
    float s = sqrt((1.0 - c) * (1.0 + c));
    float oneLessS = c * c / (1.0 + s);
    float e = 2.0 * arcTangent(c / (1.0 + s));
    const float kPoleTimesPi = 0.904129660128230; // pi/2 - 2/3
    return (oneLessS * kPoleTimesPi + s * e - s * c * oneLessS * (s + 2.0) / (3.0 * (1.0 + s))) / PI;
}

// The same for the paper's quartic fit 0.0571085289 x + 0.491881867 x^2 - 0.332181442 x^3 + 0.0714429953 x^4, x = 1 - c, expanded in c,
// where it passes the exact value at grazing by 4.6e-4.
float eonLostFitted(float c)
{
    return -4.58539989193781e-4 + c * (0.330099918 + c * (0.0760044872 + c * (-0.0464094608 - c * 0.0714429953)));
}

// Fujii's lobe, 1 where r = 0. s = VoL - NoV NoL is the cosine of the azimuth times both sines; towards -1 it comes from 1 + VoL = 2 VoH^2.
float fujiiLobe(float NoV, float NoL, float VoL, float VoH, float r)
{
    float cosines = NoV * NoL;
    float s = VoL - cosines;
    return s > 0.0 ? 1.0 + r * s / max(NoV, NoL) : (1.0 - r) + r * (2.0 * VoH * VoH - cosines);
}

vec3 eonLobes(float NoV, float NoL, float VoL, float VoH, float perceptualRoughness, vec3 baseColor, float lostView, float lostLight)
{
    float r = perceptualRoughness;
    float A = 1.0 / (1.0 + kEonGrazing * r);
    float lobe = fujiiLobe(NoV, NoL, VoL, VoH, r);
    float mean = A * (1.0 + kEonMean * r);
    vec3 multiple = baseColor * baseColor * mean / (1.0 - baseColor * (1.0 - mean));
    return (baseColor * (A * lobe) + multiple * (A * r * lostView * lostLight / (kEonGrazing - kEonMean))) / PI;
}

#endif
