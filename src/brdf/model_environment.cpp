#include "brdf/model_environment.h"

#include "brdf/environment.h"
#include "brdf/material_mapping.h"
#include "brdf/method.h"
#include "brdf/model_parts.h"
#include "brdf/phong_levels.h"

namespace torrance::brdf {

dvec3 environment_torrance_sparrow_blinn(const Preset& preset, EnvironmentQuery query, const dvec3& color,
                                         double metalness)
{
    query.f0 = dvec3(r0Of(metalness));
    const dvec3 diffuse = color * Ed_irradiance_cube(query); // color / pi * irradiance
    const dvec3 mirrored = Es_phong_levels(query);           // F Li
    const dvec3 F = schlick(query.f0, glm::dot(query.n, query.v));
    const dvec3 dielectric = mirrored + (dvec3(1) - F) * diffuse;
    const dvec3 metal = mirrored * color;
    return glm::mix(diffuse, glm::mix(dielectric, metal, metalness), preset.options.reflectivity);
}

} // namespace torrance::brdf
