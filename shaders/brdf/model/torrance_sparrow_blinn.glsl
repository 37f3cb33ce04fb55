// Source E: Blinn's D of shininess s = 2/alpha^2 - 2 in V-grooves; dielectric, metal and Lambert by metalness and reflectivity.
#include "brdf/extended.glsl"
#include "material/brdf_terms.glsl"
#include "material/half_vector.glsl"
#include "material/model_parts.glsl"

BrdfTerms model_torrance_sparrow_blinn(BrdfInput x)
{
    float NoV = dot(x.n, x.v);
    float NoL = dot(x.n, x.l);
    if (NoV <= 0.0 || NoL <= 0.0)
        return noTerms();
    HalfVector h = halfVector(x.n, x.v, x.l, NoV, NoL);
    // (s + 2)/(2 pi) n.h^s = exp((1/alpha^2 - 1) log(n.h^2)) / (pi alpha^2)
    vec2 a2 = exactProduct(x.alpha, x.alpha);
    vec2 halfPower = extendedQuotient(extendedSum(vec2(1.0, 0.0), -a2), a2);
    vec2 cos2 = h.sin2H < 0.5 ? exactSum(1.0, -h.sin2H) : exactProduct(h.NoH, h.NoH);
    vec2 exponent = extendedProduct(halfPower, -extendedLog(cos2));
    float over = grooveAttenuationOver(NoV, NoL, h.NoH, h.VoH);
    Fresnel F = schlickMix(kDielectricF0, vec3(1.0), x.metallic, h.VoH, h.oneLessVoH);

    BrdfTerms terms;
    terms.h = normalize(h.t);
    terms.D = exponent.x < kExponentUnderflow ? scaledExp(1.0 / (PI * a2.x), exponent) : 0.0;
    terms.G1 = min(1.0, 2.0 * h.NoH * NoV / h.VoH);
    terms.G = over * NoV * NoL;
    terms.V = 0.25 * over;
    terms.F0 = F.f0;
    terms.F = F.reflected;
    vec3 layer = terms.F * (terms.D * terms.V);
    vec3 lambert = x.baseColor / PI;
    vec3 dielectric = (1.0 - x.metallic) * F.transmitted * lambert;
    terms.specular = PARAMETER_reflectivity * blended(layer, layer * x.baseColor, x.metallic);
    terms.diffuse = blended(lambert, dielectric, PARAMETER_reflectivity);
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = NoL;
    return terms;
}
