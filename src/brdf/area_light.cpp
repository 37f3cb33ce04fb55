#include "brdf/area_light.h"

#include "brdf/brdf.h"

#include <algorithm>

namespace torrance::brdf {
namespace {

// The surface lit from l.
ShadingPoint litFrom(const AreaQuery& query, const dvec3& l)
{
    const ShadingPoint& surface = query.surface;
    ShadingPoint point = makeShadingPoint(surface.n, surface.v, l, surface.perceptualRoughness);
    point.baseColor = surface.baseColor;
    point.metallic = surface.metallic;
    return point;
}

// A light in the point itself is straight above it.
dvec3 directionOfCenter(const AreaQuery& query)
{
    const double distance = glm::length(query.toCenter);
    return distance > 0 ? query.toCenter / distance : query.surface.n;
}

} // namespace

dvec3 A_point(const AreaQuery& query)
{
    const ShadingPoint point = litFrom(query, directionOfCenter(query));
    if (point.NoL <= 0)
        return dvec3(0);
    const double distance = std::max(glm::length(query.toCenter), kLeastLightDistance);
    return evaluateBrdf(query.methods, point) * query.intensity * (point.NoL / (distance * distance));
}

} // namespace torrance::brdf
