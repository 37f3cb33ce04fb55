// Fresnel's equations for the index eta + i k, per channel.
#include "brdf/conductor.glsl"

vec3 F_exact_conductor(float VoH, float oneLessVoH, vec3 f0, vec3 f90, float ior, vec3 eta, vec3 k, vec3 f82)
{
    float c = clamp(VoH, 0.0, 1.0);
    return vec3(conductorReflectance(c, eta.r, k.r), conductorReflectance(c, eta.g, k.g), conductorReflectance(c, eta.b, k.b));
}
