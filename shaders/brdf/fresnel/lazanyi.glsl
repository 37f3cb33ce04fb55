// Lazanyi & Szirmay-Kalos 2005: Schlick's term of an index eta + i k, less a c (1 - c)^6 with the height a that meets Fresnel's equations at
// the cosine 1/7 (Hoffman 2019). Held within [0, 1], which weakly absorbing indices near 1 leave. Index 1 is no interface: exactly 0.
#include "brdf/conductor.glsl"

vec3 F_lazanyi(float VoH, float oneLessVoH, vec3 f0, vec3 f90, float ior, vec3 eta, vec3 k, vec3 f82)
{
    const float kPower5 = 0.462664366631; // (6/7)^5
    const float kInverseDip = 17.6513846022; // 7^7 / 6^6
    float x2 = oneLessVoH * oneLessVoH;
    float x5 = x2 * x2 * oneLessVoH;
    vec3 apart = (eta - 1.0) * (eta - 1.0) + k * k;
    vec3 whole = apart + 4.0 * eta;
    vec3 exact = vec3(conductorReflectance(1.0 / 7.0, eta.r, k.r), conductorReflectance(1.0 / 7.0, eta.g, k.g), conductorReflectance(1.0 / 7.0, eta.b, k.b));
    vec3 a = ((apart + 4.0 * eta * kPower5) / whole - exact) * kInverseDip;
    vec3 F = (apart + 4.0 * eta * x5) / whole - a * (clamp(VoH, 0.0, 1.0) * x5 * oneLessVoH);
    return mix(clamp(F, 0.0, 1.0), vec3(0.0), equal(apart, vec3(0.0)));
}
