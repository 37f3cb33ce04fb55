// Source D: GGX with alpha = r^2, Smith's G1 with r in place of alpha, and a diffuse term of l.n alone.
#include "brdf/brdf.h"
#include "brdf/model.h"
#include "brdf/model_parts.h"

namespace torrance::brdf {
namespace {

double smithMasking(double x, double r)
{
    return 2.0 * x / (x + std::sqrt(r * r + (1.0 - r * r) * x * x));
}

} // namespace

BrdfTerms model_smith_r(const Preset&, const ShadingPoint& point)
{
    BrdfTerms terms;
    if (isDark(point))
        return terms;
    const double r = point.perceptualRoughness;
    terms.h = halfVector(point);
    terms.D = trowbridgeReitz(point.NoH, point.alpha);
    terms.G1 = smithMasking(point.NoV, r);
    terms.G = terms.G1 * smithMasking(point.NoL, r);
    terms.V = terms.G / (4.0 * point.NoV * point.NoL);
    terms.F0 = glm::mix(dvec3(kDielectricF0), point.baseColor, point.metallic);
    terms.F = schlick(terms.F0, point.VoH);
    terms.specular = terms.D * terms.V * terms.F;
    terms.diffuse = point.baseColor; // times l.n to the letter: neither 1/pi nor (1 - F), and metals too
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = point.NoL;
    return terms;
}

} // namespace torrance::brdf
