// glTF 2.0, Appendix B, from the methods of selected.glsl, which is what includes this file.
#include "material/brdf_terms.glsl"
#include "material/dielectric_f0.glsl"
#include "material/half_vector.glsl"
#include "material/reflectance.glsl"
#include "shared/constants.h"

BrdfTerms model_gltf(BrdfInput x)
{
    float NoV = dot(x.n, x.v);
    float NoL = dot(x.n, x.l);
    if (NoV <= 0.0 || NoL <= 0.0)
        return noTerms();
    HalfVector h = halfVector(x.n, x.v, x.l, NoV, NoL);

    BrdfTerms terms;
    terms.h = normalize(h.t);
    // An isotropic surface has one alpha in every direction; so its tangent may be the one that h lies over.
    terms.D = SELECTED_distribution(h.NoH, h.sin2H, x.alpha, sqrt(h.sin2H), 0.0, x.alpha, x.alpha);
    terms.V = SELECTED_visibility(NoV, NoL, h.NoH, h.VoH, x.alpha, x.perceptualRoughness);
    terms.G = 4.0 * NoV * NoL * terms.V;
    terms.G1 = 4.0 * NoV * SELECTED_visibility(NoV, 1.0, h.NoH, h.VoH, x.alpha, x.perceptualRoughness);
    float specular = terms.D * terms.V;
    vec3 diffuse = SELECTED_diffuse(NoV, NoL, dot(x.v, x.l), h.NoH, h.VoH, x.alpha, x.perceptualRoughness, x.baseColor);

    vec3 f0 = vec3(dielectricF0(x.ior));
    vec3 F = reflectance(h.VoH, h.oneLessVoH, f0);
    vec3 metalF = reflectance(h.VoH, h.oneLessVoH, x.baseColor);
    LobeAlbedo a = x.lobe;
    const vec3 spread = vec3(1.0 / PI);
    vec3 reflected = SELECTED_multiple_scattering(specular * F, spread, f0, a.bias, a.E, a.ELight, a.EAverage);
    vec3 metal = SELECTED_multiple_scattering(specular * metalF, spread, x.baseColor, a.bias, a.E, a.ELight, a.EAverage);

    // The albedo of the dielectric's whole lobe: what it returns of uniform light.
    vec3 returned = SELECTED_multiple_scattering(f0 * (a.E - a.bias) + a.bias, vec3(1.0), f0, a.bias, a.E, a.EAverage, a.EAverage);
    vec3 body = diffuse * SELECTED_diffuse_weight(F, reflectance(NoV, 1.0 - NoV, f0), reflectance(NoL, 1.0 - NoL, f0), returned);

    // Not mix(): a(1 - m) + b m is a at m = 0 and b at m = 1, to the bit.
    float m = x.metallic;
    terms.F0 = f0 * (1.0 - m) + x.baseColor * m;
    terms.F = F * (1.0 - m) + metalF * m;
    terms.specular = reflected * (1.0 - m) + metal * m;
    terms.diffuse = body * (1.0 - m);
    terms.brdf = (body + reflected) * (1.0 - m) + metal * m;
    terms.weight = NoL;
    return terms;
}
