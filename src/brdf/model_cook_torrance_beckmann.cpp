// Source B, second rung: Cook & Torrance 1982 with Beckmann's distribution, slope m = alpha.
#include "brdf/brdf.h"
#include "brdf/model.h"
#include "brdf/model_parts.h"

namespace torrance::brdf {

BrdfTerms model_cook_torrance_beckmann(const Preset& preset, const ShadingPoint& point)
{
    BrdfTerms terms;
    if (isDark(point))
        return terms;
    const double m2 = point.alpha * point.alpha;
    const double cos2 = point.NoH * point.NoH;
    const double tan2 = (1.0 - cos2) / cos2;
    const double denominator = preset.options.piDenominator ? kPi : 4.0;
    terms.h = halfVector(point);
    terms.D = std::exp(-tan2 / m2) / (kPi * m2 * cos2 * cos2);
    terms.G1 = grooveMasking(point);
    terms.G = grooveAttenuation(point);
    terms.V = terms.G / (denominator * point.NoL * point.NoV);
    terms.F0 = glm::mix(dvec3(kDielectricF0), point.baseColor, point.metallic);
    terms.F = schlick(terms.F0, point.VoH);
    terms.specular = terms.D * terms.V * terms.F;
    terms.diffuse = (dvec3(1) - terms.F) * (1.0 - point.metallic) * point.baseColor / kPi;
    if (preset.options.energySketch) {
        terms.brdf = terms.diffuse * point.NoL + terms.specular / point.NoL;
        terms.weight = 1.0;
        return terms;
    }
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = point.NoL;
    return terms;
}

} // namespace torrance::brdf
