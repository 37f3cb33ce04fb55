// Source B, third rung: GGX, Schlick's G with k = (r + 1)^2 / 8, f0 = 0.5, Burley's diffuse with alpha in f90 and no (1 - F).
#include "material/brdf_terms.glsl"
#include "material/half_vector.glsl"
#include "material/model_parts.glsl"

BrdfTerms model_ggx_burley(BrdfInput x)
{
    const float kF0 = 0.5;       // the source's dielectric
    const float kEpsilon = 1e-6; // the source adds it to 4 n.l n.v
    float NoV = dot(x.n, x.v);
    float NoL = dot(x.n, x.l);
    if (NoV <= 0.0 || NoL <= 0.0)
        return noTerms();
    HalfVector h = halfVector(x.n, x.v, x.l, NoV, NoL);
    float k = (0.125 * x.perceptualRoughness + 0.25) * x.perceptualRoughness + 0.125;
    float f90Less1 = 2.0 * x.alpha * h.VoH * h.VoH - 0.5;
    float light = (1.0 - NoL) * (1.0 - NoL);
    float view = (1.0 - NoV) * (1.0 - NoV);
    light *= light * (1.0 - NoL);
    view *= view * (1.0 - NoV);
    Fresnel F = schlickMix(kF0, x.baseColor, x.metallic, h.VoH, h.oneLessVoH);

    BrdfTerms terms;
    terms.h = normalize(h.t);
    terms.D = trowbridgeReitz(h.sin2H, x.alpha);
    terms.G1 = NoV * schlickMaskingOver(NoV, k);
    terms.G = terms.G1 * NoL * schlickMaskingOver(NoL, k);
    terms.V = terms.G / (4.0 * NoV * NoL + kEpsilon);
    terms.F0 = F.f0;
    terms.F = F.reflected;
    terms.specular = terms.F * (terms.D * terms.V);
    terms.diffuse = x.baseColor * ((1.0 - x.metallic) / PI * (1.0 + f90Less1 * light) * (1.0 + f90Less1 * view));
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = QUIRK_no_cosine ? 1.0 : NoL;
    return terms;
}
