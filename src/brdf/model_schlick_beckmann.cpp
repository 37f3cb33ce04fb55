// Source C: GGX, Schlick's G with k = alpha / 2, Lambert under 1 - F with no metallic in it.
#include "brdf/brdf.h"
#include "brdf/model.h"
#include "brdf/model_parts.h"

namespace torrance::brdf {
namespace {

constexpr double kLeastSourceDenominator = 1e-6; // of 4 (v.n)(l.n): it dims the lobe where v.n l.n < 2.5e-7

} // namespace

BrdfTerms model_schlick_beckmann(const Preset& preset, const ShadingPoint& point)
{
    BrdfTerms terms;
    if (isDark(point)) // all dots are clamped at 0
        return terms;
    const double k = point.alpha / 2.0;
    terms.h = halfVector(point);
    terms.D = trowbridgeReitz(point.NoH, point.alpha);
    terms.G1 = schlickMasking(point.NoV, k);
    terms.G = terms.G1 * schlickMasking(point.NoL, k);
    terms.V = terms.G / std::max(4.0 * point.NoV * point.NoL, kLeastSourceDenominator);
    terms.F0 = glm::mix(dvec3(kDielectricF0), point.baseColor, point.metallic);
    terms.F = schlick(terms.F0, point.VoH);
    terms.specular = terms.D * terms.V * terms.F;
    if (preset.options.doubleFresnel)
        terms.specular *= terms.F; // Ks = F
    terms.diffuse = (dvec3(1) - terms.F) * point.baseColor / kPi;
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = point.NoL;
    return terms;
}

} // namespace torrance::brdf
