// Source B, second rung: Cook & Torrance 1982, Beckmann's D of slope m = alpha, V-grooves, Schlick's F.
#include "brdf/extended.glsl"
#include "material/brdf_terms.glsl"
#include "material/half_vector.glsl"
#include "material/model_parts.glsl"

BrdfTerms model_cook_torrance_beckmann(BrdfInput x)
{
    const float kDenominator = QUIRK_pi_denominator ? PI : 4.0;
    float NoV = dot(x.n, x.v);
    float NoL = dot(x.n, x.l);
    if (NoV <= 0.0 || NoL <= 0.0)
        return noTerms();
    HalfVector h = halfVector(x.n, x.v, x.l, NoV, NoL);
    vec2 cos2 = exactProduct(h.NoH, h.NoH);
    vec2 m2 = exactProduct(x.alpha, x.alpha);
    vec2 exponent = extendedQuotient(vec2(h.sin2H, 0.0), extendedProduct(cos2, m2)); // tan^2 / m^2
    float over = grooveAttenuationOver(NoV, NoL, h.NoH, h.VoH);
    Fresnel F = schlickMix(kDielectricF0, x.baseColor, x.metallic, h.VoH, h.oneLessVoH);

    BrdfTerms terms;
    terms.h = normalize(h.t);
    terms.D = exponent.x < kExponentUnderflow ? scaledExp(1.0 / (PI * m2.x * cos2.x * cos2.x), exponent) : 0.0;
    terms.G1 = min(1.0, 2.0 * h.NoH * NoV / h.VoH);
    terms.G = over * NoV * NoL;
    terms.V = over / kDenominator;
    terms.F0 = F.f0;
    terms.F = F.reflected;
    terms.specular = terms.F * (terms.D * terms.V);
    terms.diffuse = x.baseColor * (F.transmitted * ((1.0 - x.metallic) / PI));
    terms.brdf = QUIRK_energy_sketch ? terms.diffuse * NoL + terms.specular / NoL : terms.diffuse + terms.specular;
    terms.weight = QUIRK_energy_sketch ? 1.0 : NoL;
    return terms;
}
