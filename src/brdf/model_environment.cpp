#include "brdf/model_environment.h"

#include "brdf/environment.h"
#include "brdf/ggx_levels.h"
#include "brdf/integration_map.h"
#include "brdf/material_mapping.h"
#include "brdf/method.h"
#include "brdf/model_parts.h"
#include "brdf/phong_levels.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

constexpr double kRefractionRatio = 0.8; // source B's, of the indices outside and inside

// Snell's law: the part along the surface is shortened by the ratio and goes on beyond it. A ratio below 1 refracts
// every direction.
dvec3 refractedDirection(const EnvironmentQuery& query)
{
    const dvec3 along = -kRefractionRatio * (query.v - glm::dot(query.n, query.v) * query.n);
    return along - std::sqrt(1.0 - glm::dot(along, along)) * query.n;
}

} // namespace

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

dvec3 environment_ggx_burley(const Preset& preset, EnvironmentQuery query, const dvec3& base, double metalness)
{
    query.f0 = glm::mix(dvec3(0.5), base, metalness);
    const double NoV = std::min(glm::dot(query.n, query.v), 1.0);
    const dvec3 map = integrationMap(NoV, query.perceptualRoughness);
    const dvec3 F = preset.options.fresnelAtView ? schlick(query.f0, NoV) : query.f0;
    const dvec3 L = ggxLevelRadiance(query, kGgxLevels - (preset.options.fiveLevels ? 2 : 1));
    const dvec3 diffuse = (1.0 - metalness) * base * Ed_irradiance_cube(query);
    return L * (F * map.x + map.y) + diffuse * map.z;
}

dvec3 environment_phong(const Preset& preset, const EnvironmentQuery& query, const dvec3& lit)
{
    const ModelOptions& options = preset.options;
    const dvec3 body = glm::mix(lit, query.radiance(refractedDirection(query)), options.refraction);
    const double fresnel = std::pow(1.0 - std::max(glm::dot(query.n, query.v), 0.0), options.fresnelExponent);
    return glm::mix(body, Es_mirror(query), options.reflection * fresnel);
}

} // namespace torrance::brdf
