// Source A: D with alpha = r, Schlick's G with k = (r + 1)^2 / 8 (Karis 2013, eq. 4), Lambert under (1 - F)(1 - metallic).
#include "material/brdf_terms.glsl"
#include "material/half_vector.glsl"
#include "material/model_parts.glsl"

BrdfTerms model_ue4_direct(BrdfInput x)
{
    // The source's own bound of every denominator. That of G1 is at least k >= 1/8, which needs none.
    const float kLeast = 1e-4;
    float NoV = dot(x.n, x.v);
    float NoL = dot(x.n, x.l);
    if (NoV <= 0.0 || NoL <= 0.0)
        return noTerms();
    HalfVector h = halfVector(x.n, x.v, x.l, NoV, NoL);

    float a2 = x.perceptualRoughness * x.perceptualRoughness;
    float d = trowbridgeReitzBase(h.sin2H, a2);
    float k = (0.125 * x.perceptualRoughness + 0.25) * x.perceptualRoughness + 0.125;
    Fresnel F = schlickMix(kDielectricF0, x.baseColor, x.metallic, h.VoH, h.oneLessVoH);

    BrdfTerms terms;
    terms.h = normalize(h.t);
    terms.D = a2 / max(PI * d * d, kLeast);
    terms.G1 = NoV * schlickMaskingOver(NoV, k);
    terms.G = terms.G1 * NoL * schlickMaskingOver(NoL, k);
    terms.V = terms.G / max(4.0 * NoV * NoL, kLeast);
    terms.F0 = F.f0;
    terms.F = F.reflected;
    terms.specular = (QUIRK_double_fresnel ? terms.F * terms.F : terms.F) * (terms.D * terms.V);
    terms.diffuse = x.baseColor * (F.transmitted * ((1.0 - x.metallic) / PI));
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = NoL;
    return terms;
}
