// Source B, first rung: Phong 1975. The formula holds its own cosine, so the light is not multiplied by another.
#include "brdf/material_mapping.h"
#include "brdf/method.h"
#include "brdf/model.h"
#include "brdf/model_parts.h"

namespace torrance::brdf {

// ambient + n.l + factor * max(R.v, 0)^glossiness with R = reflect(-l, n): the slide's reflect(N, V) is a slip. The
// base colour multiplies the first two. Nothing turns the highlight off where n.l < 0: neither does the source.
BrdfTerms model_phong(const Preset& preset, const ShadingPoint& point)
{
    const dvec3 R = 2.0 * point.NoL * point.n - point.l;
    const double RoV = glm::dot(R, point.v);
    const double glossiness = glossinessOf(point.perceptualRoughness);
    const double highlight = RoV > 0 ? std::pow(RoV, glossiness) : 0.0;
    BrdfTerms terms;
    if (point.VoH > 0)
        terms.h = halfVector(point);
    terms.diffuse = point.baseColor * (preset.options.ambient + std::max(point.NoL, 0.0));
    terms.specular = dvec3(preset.options.specularFactor * highlight);
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = 1.0;
    return terms;
}

} // namespace torrance::brdf
