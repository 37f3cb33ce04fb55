// The glTF material's BRDF (glTF 2.0, Appendix B) from the methods of selected.glsl, which is included before this file.
#include "shared/constants.h"

// 1/sr per channel, without the cosine NoL; 0 where v or l is not above the surface. n, v, l are unit and point away from the surface;
// alpha = max(perceptualRoughness^2, kMinAlpha); E is the directional albedo at NoV of the specular lobe with F = 1, read only where the
// selection compensates for multiple scattering.
vec3 brdf(vec3 n, vec3 v, vec3 l, vec3 baseColor, float metallic, float perceptualRoughness, float alpha, float E)
{
    float NoV = dot(n, v);
    float NoL = dot(n, l);
    if (NoV <= 0.0 || NoL <= 0.0)
        return vec3(0.0);

    // t is not normalised: its length is 2 VoH, and its cross product with n keeps the digits that 1 - NoH^2 would lose. v and l are unit
    // up to rounding only, and at grazing, where t is short, what their lengths differ by would tilt it: |v| - |l| = t.d / 2 to first
    // order, taken out along d.
    vec3 t = v + l;
    vec3 d = v - l;
    t -= d * (0.25 * dot(t, d));
    vec3 nxt = cross(n, t);
    float length2 = dot(t, t);
    float NoH = (NoV + NoL) * inversesqrt(length2);
    float VoH = 0.5 * sqrt(length2);
    float oneLessVoH = 0.25 * dot(d, d) / (1.0 + VoH);
    float sin2H = dot(nxt, nxt) / length2;

    float specular = SELECTED_distribution(NoH, sin2H, alpha) *
                     SELECTED_visibility(NoV, NoL, NoH, VoH, alpha, perceptualRoughness);
    vec3 diffuse = SELECTED_diffuse(NoV, NoL, dot(v, l), VoH, perceptualRoughness, baseColor);

    const vec3 f0 = vec3(kDielectricF0);
    vec3 F = SELECTED_fresnel(VoH, oneLessVoH, f0, vec3(1.0), kDielectricIor, vec3(kDielectricIor), vec3(0.0));
    vec3 dielectric = diffuse * (1.0 - F) + specular * F * SELECTED_multiple_scattering(f0, E);

    vec3 metalF = SELECTED_fresnel(VoH, oneLessVoH, baseColor, vec3(1.0), kDielectricIor, vec3(kDielectricIor), vec3(0.0));
    vec3 metal = specular * metalF * SELECTED_multiple_scattering(baseColor, E);

    // Not mix(): a(1 - m) + b m is a at m = 0 and b at m = 1, to the bit.
    return dielectric * (1.0 - metallic) + metal * metallic;
}
