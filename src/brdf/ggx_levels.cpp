#include "brdf/ggx_levels.h"

#include "brdf/environment.h"
#include "brdf/integration_map.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

dvec3 levelRadiance(const EnvironmentQuery& query, const dvec3& axis, int level)
{
    return level == 0 ? query.radiance(axis) : ggxMean(query, axis, ggxLevelAlpha(level));
}

} // namespace

double ggxLevelAlpha(int level)
{
    const double perceptualRoughness = static_cast<double>(level) / (kGgxLevels - 1);
    return perceptualRoughness * perceptualRoughness;
}

double ggxLevel(double perceptualRoughness, int lastLevel)
{
    const double r = std::max(perceptualRoughness, std::sqrt(kMinAlpha));
    return std::min(r * (kGgxLevels - 1), static_cast<double>(lastLevel));
}

dvec3 ggxLevelRadiance(const EnvironmentQuery& query, int lastLevel)
{
    const double lod = ggxLevel(query.perceptualRoughness, lastLevel);
    const int lower = std::min(static_cast<int>(lod), lastLevel - 1);
    const dvec3 axis = mirrorDirection(query);
    return glm::mix(levelRadiance(query, axis, lower), levelRadiance(query, axis, lower + 1), lod - lower);
}

dvec3 Es_ggx_levels(const EnvironmentQuery& query)
{
    const dvec3 map = integrationMap(std::min(glm::dot(query.n, query.v), 1.0), query.perceptualRoughness);
    return ggxLevelRadiance(query) * (query.f0 * map.x + map.y);
}

} // namespace torrance::brdf
