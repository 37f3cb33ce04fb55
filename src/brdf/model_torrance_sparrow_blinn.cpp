// Source E: Torrance & Sparrow's attenuation with Blinn's distribution, between a dielectric, a metal and Lambert.
#include "brdf/material_mapping.h"
#include "brdf/method.h"
#include "brdf/model.h"
#include "brdf/model_parts.h"

namespace torrance::brdf {

BrdfTerms model_torrance_sparrow_blinn(const Preset& preset, const ShadingPoint& point)
{
    BrdfTerms terms;
    if (isDark(point)) // "black where n.l <= 0"
        return terms;
    const double s = shininessOf(point.perceptualRoughness);
    const double reflectivity = preset.options.reflectivity;
    const double metalness = point.metallic;
    terms.h = halfVector(point);
    terms.D = (s + 2.0) / (2.0 * kPi) * std::pow(point.NoH, s);
    terms.G1 = grooveMasking(point);
    terms.G = grooveAttenuation(point);
    terms.V = terms.G / (4.0 * point.NoV * point.NoL);
    terms.F0 = dvec3(r0Of(metalness));
    terms.F = schlick(terms.F0, point.VoH);

    const dvec3 diffuse = point.baseColor / kPi;
    const dvec3 brdf = terms.D * terms.V * terms.F;
    // mix(diffuse, mix(brdf + (1 - F) diffuse, brdf color, metalness), reflectivity), taken apart
    terms.specular = reflectivity * glm::mix(brdf, brdf * point.baseColor, metalness);
    terms.diffuse = glm::mix(diffuse, (1.0 - metalness) * (dvec3(1) - terms.F) * diffuse, reflectivity);
    terms.brdf = terms.diffuse + terms.specular;
    terms.weight = point.NoL;
    return terms;
}

} // namespace torrance::brdf
