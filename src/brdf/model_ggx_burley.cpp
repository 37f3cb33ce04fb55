// Source B, third rung: GGX with Burley's diffuse, a dielectric reflectance of one half and no (1 - F).
#include "brdf/method.h"
#include "brdf/model.h"
#include "brdf/model_parts.h"
#include "math/powers.h"

namespace torrance::brdf {
namespace {

constexpr double kSourceF0 = 0.5; // the source's, not 0.04

// Added to 4 (n.l)(n.v): it dims the lobe by a part in a thousand where n.l n.v = 2.5e-4.
constexpr double kSourceEpsilon = 1e-6;

double burley(const ShadingPoint& p)
{
    const double f90 = 0.5 + 2.0 * p.alpha * p.VoH * p.VoH;
    return (1.0 + (f90 - 1.0) * fifthPower(1.0 - p.NoL)) * (1.0 + (f90 - 1.0) * fifthPower(1.0 - p.NoV)) / kPi;
}

} // namespace

BrdfTerms model_ggx_burley(const Preset& preset, const ShadingPoint& point)
{
    BrdfTerms terms;
    if (isDark(point))
        return terms;
    const double r = point.perceptualRoughness;
    const double k = (r + 1.0) * (r + 1.0) / 8.0;
    terms.h = halfVector(point);
    terms.D = trowbridgeReitz(point.NoH, point.alpha);
    terms.G1 = schlickMasking(point.NoV, k);
    terms.G = terms.G1 * schlickMasking(point.NoL, k);
    terms.V = terms.G / (4.0 * point.NoL * point.NoV + kSourceEpsilon);
    terms.F0 = glm::mix(dvec3(kSourceF0), point.baseColor, point.metallic);
    terms.F = schlick(terms.F0, point.VoH); // l.h = v.h
    terms.specular = terms.D * terms.V * terms.F;
    terms.diffuse = (1.0 - point.metallic) * point.baseColor * burley(point);
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = preset.options.noCosine ? 1.0 : point.NoL;
    return terms;
}

} // namespace torrance::brdf
