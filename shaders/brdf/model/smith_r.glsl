// Source D: GGX with alpha = r^2, Smith's G1 with r in place of alpha, diffuse l.n alone.
#include "material/brdf_terms.glsl"
#include "material/half_vector.glsl"
#include "material/model_parts.glsl"

BrdfTerms model_smith_r(BrdfInput x)
{
    float NoV = dot(x.n, x.v);
    float NoL = dot(x.n, x.l);
    if (NoV <= 0.0 || NoL <= 0.0)
        return noTerms();
    HalfVector h = halfVector(x.n, x.v, x.l, NoV, NoL);
    // r^2 + (1 - r^2) c^2 = r^2 (1 - c)(1 + c) + c^2; G / (4 NoV NoL) is 1 / (both sums), without the cosines
    float r2 = x.perceptualRoughness * x.perceptualRoughness;
    float view = NoV + sqrt(r2 * ((1.0 - NoV) * (1.0 + NoV)) + NoV * NoV);
    float light = NoL + sqrt(r2 * ((1.0 - NoL) * (1.0 + NoL)) + NoL * NoL);
    Fresnel F = schlickMix(kDielectricF0, x.baseColor, x.metallic, h.VoH, h.oneLessVoH);

    BrdfTerms terms;
    terms.h = normalize(h.t);
    terms.D = trowbridgeReitz(h.sin2H, x.alpha);
    terms.G1 = 2.0 * NoV / view;
    terms.G = terms.G1 * (2.0 * NoL / light);
    terms.V = 1.0 / view / light;
    terms.F0 = F.f0;
    terms.F = F.reflected;
    terms.specular = terms.F * (terms.D * terms.V);
    terms.diffuse = x.baseColor;
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = NoL;
    return terms;
}
