// Source C: GGX, Schlick's G with k = alpha / 2, Schlick's F, Lambert under 1 - F with no metallic in it.
#include "material/brdf_terms.glsl"
#include "material/half_vector.glsl"
#include "material/model_parts.glsl"

BrdfTerms model_schlick_beckmann(BrdfInput x)
{
    const float kLeast = 1e-6; // the source's bound of 4 v.n l.n
    float NoV = dot(x.n, x.v);
    float NoL = dot(x.n, x.l);
    if (NoV <= 0.0 || NoL <= 0.0)
        return noTerms();
    HalfVector h = halfVector(x.n, x.v, x.l, NoV, NoL);
    float k = 0.5 * x.alpha;
    Fresnel F = schlickMix(kDielectricF0, x.baseColor, x.metallic, h.VoH, h.oneLessVoH);

    BrdfTerms terms;
    terms.h = normalize(h.t);
    terms.D = trowbridgeReitz(h.sin2H, x.alpha);
    terms.G1 = NoV * schlickMaskingOver(NoV, k);
    terms.G = terms.G1 * NoL * schlickMaskingOver(NoL, k);
    terms.V = terms.G / max(4.0 * NoV * NoL, kLeast);
    terms.F0 = F.f0;
    terms.F = F.reflected;
    terms.specular = (QUIRK_double_fresnel ? terms.F * terms.F : terms.F) * (terms.D * terms.V);
    terms.diffuse = x.baseColor * (F.transmitted / PI);
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = NoL;
    return terms;
}
