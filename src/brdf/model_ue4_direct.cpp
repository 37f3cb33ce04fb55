// Source A: Karis' terms for punctual lights as a tutorial has them, with alpha = r.
#include "brdf/brdf.h"
#include "brdf/model.h"
#include "brdf/model_parts.h"

namespace torrance::brdf {
namespace {

// The source bounds every denominator from below by 1e-4. It caps D where pi (n.h^2 (r^2 - 1) + 1)^2 is less, inside
// highlights of r < 0.075, and dims the lobe where n.v n.l < 2.5e-5. That of G1 is at least k >= 1/8.
constexpr double kLeastSourceDenominator = 1e-4;

double over(double numerator, double denominator)
{
    return numerator / std::max(denominator, kLeastSourceDenominator);
}

} // namespace

BrdfTerms model_ue4_direct(const Preset& preset, const ShadingPoint& point)
{
    BrdfTerms terms;
    if (isDark(point))
        return terms;
    const double r = point.perceptualRoughness;
    const double d = point.NoH * point.NoH * (r * r - 1.0) + 1.0;
    const double k = (r + 1.0) * (r + 1.0) / 8.0;
    terms.h = halfVector(point);
    terms.D = over(r * r, kPi * d * d);
    terms.G1 = schlickMasking(point.NoV, k);
    terms.G = terms.G1 * schlickMasking(point.NoL, k);
    terms.V = over(terms.G, 4.0 * point.NoV * point.NoL);
    terms.F0 = glm::mix(dvec3(kDielectricF0), point.baseColor, point.metallic);
    terms.F = schlick(terms.F0, point.VoH);
    terms.specular = terms.D * terms.V * terms.F;
    if (preset.options.doubleFresnel)
        terms.specular *= terms.F; // ks = F
    terms.diffuse = (dvec3(1) - terms.F) * (1.0 - point.metallic) * point.baseColor / kPi;
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = point.NoL;
    return terms;
}

} // namespace torrance::brdf
