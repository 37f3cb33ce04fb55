// Source B, first rung: base colour * (ambient + n.l) + factor * max(R.v, 0)^glossiness, R = reflect(-l, n). The cosine stands inside.
#include "brdf/extended.glsl"
#include "material/brdf_terms.glsl"
#include "shared/constants.h"

BrdfTerms model_phong(BrdfInput x)
{
    float NoL = dot(x.n, x.l);
    float RoV = 2.0 * NoL * dot(x.n, x.v) - dot(x.l, x.v);
    // Where the highlight is, R.v has no digits left: 1 - R.v = |R - v|^2 / 2.
    vec3 apart = 2.0 * NoL * x.n - (x.l + x.v);
    vec2 cosine = RoV > 0.5 ? exactSum(1.0, -0.5 * dot(apart, apart)) : vec2(RoV, 0.0);
    vec2 a2 = exactProduct(x.alpha, x.alpha);
    vec2 glossiness = extendedQuotient(0.5 * extendedSum(vec2(1.0, 0.0), -a2), a2); // (2 / alpha^2 - 2) / 4
    float highlight = 0.0;
    if (RoV > 0.0) {
        vec2 exponent = extendedProduct(glossiness, -extendedLog(cosine));
        highlight = exponent.x < kExponentUnderflow ? scaledExp(1.0, exponent) : 0.0;
    }

    BrdfTerms terms = noTerms();
    vec3 t = x.v + x.l;
    terms.h = dot(t, t) > 0.0 ? normalize(t) : vec3(0.0);
    terms.diffuse = x.baseColor * (PARAMETER_ambient + max(NoL, 0.0));
    terms.specular = vec3(PARAMETER_specular * highlight);
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = 1.0;
    return terms;
}
