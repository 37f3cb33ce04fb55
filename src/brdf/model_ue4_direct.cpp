// Source A: Karis' terms for punctual lights as a tutorial has them, with alpha = r.
#include "brdf/brdf.h"
#include "brdf/model.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

// The source bounds every denominator from below by 1e-4. It caps D where pi (n.h^2 (r^2 - 1) + 1)^2 is less, inside
// highlights of r < 0.075, and dims the lobe where n.v n.l < 2.5e-5.
constexpr double kLeastSourceDenominator = 1e-4;

double over(double numerator, double denominator)
{
    return numerator / std::max(denominator, kLeastSourceDenominator);
}

double schlickMasking(double cosine, double k)
{
    return over(cosine, cosine * (1.0 - k) + k);
}

} // namespace

BrdfTerms model_ue4_direct(const Preset&, const ShadingPoint& point)
{
    BrdfTerms terms;
    if (point.NoV <= 0 || point.NoL <= 0)
        return terms;
    const double r = point.perceptualRoughness;
    const double d = point.NoH * point.NoH * (r * r - 1.0) + 1.0;
    const double k = (r + 1.0) * (r + 1.0) / 8.0;
    terms.h = glm::normalize(point.v + point.l);
    terms.D = over(r * r, kPi * d * d);
    terms.G1 = schlickMasking(point.NoV, k);
    terms.G = terms.G1 * schlickMasking(point.NoL, k);
    terms.V = over(terms.G, 4.0 * point.NoV * point.NoL);
    terms.F0 = glm::mix(dvec3(kDielectricF0), point.baseColor, point.metallic);
    terms.F = terms.F0 + (dvec3(1) - terms.F0) * std::pow(1.0 - point.VoH, 5);
    terms.specular = terms.D * terms.V * terms.F;
    terms.diffuse = (dvec3(1) - terms.F) * (1.0 - point.metallic) * point.baseColor / kPi;
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = point.NoL;
    return terms;
}

} // namespace torrance::brdf
