#include "brdf/area_light.h"

#include "brdf/brdf.h"
#include "math/frame.h"
#include "math/low_discrepancy.h"
#include "math/pixel_rotation.h"
#include "math/sampling.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

// The surface lit from l.
ShadingPoint litFrom(const AreaQuery& query, const dvec3& l)
{
    const ShadingPoint& surface = query.surface;
    ShadingPoint point = makeShadingPoint(surface.n, surface.v, l, surface.perceptualRoughness);
    point.baseColor = surface.baseColor;
    point.metallic = surface.metallic;
    point.ior = surface.ior;
    return point;
}

// A light in the point itself is straight above it.
dvec3 directionOfCenter(const AreaQuery& query)
{
    const double distance = glm::length(query.toCenter);
    return distance > 0 ? query.toCenter / distance : query.surface.n;
}

/// Irradiance, straight on, of the whole intensity in the centre; on and in the sphere as from its surface.
dvec3 farIrradiance(const AreaQuery& query)
{
    const double distance = std::max({glm::length(query.toCenter), query.radius, kLeastLightDistance});
    return query.intensity / (distance * distance);
}

/// The direction of the sphere's point nearest to the ray along `mirror`.
dvec3 nearestToRay(const AreaQuery& query, const dvec3& mirror)
{
    const dvec3 off = query.toCenter - glm::dot(query.toCenter, mirror) * mirror; // from the ray to the centre
    const double far = glm::length(off);
    if (glm::length(query.toCenter) <= query.radius)
        return mirror;
    const double share = far > query.radius ? query.radius / far : 1.0;
    return glm::normalize(query.toCenter - share * off);
}

} // namespace

dvec3 A_point(const AreaQuery& query)
{
    const ShadingPoint point = litFrom(query, directionOfCenter(query));
    if (point.NoL <= 0)
        return dvec3(0);
    const double distance = std::max(glm::length(query.toCenter), kLeastLightDistance);
    return evaluateTerms(query.methods, point).response() * query.intensity / (distance * distance);
}

dvec3 A_representative(const AreaQuery& query)
{
    const dvec3 center = directionOfCenter(query);
    const dvec3& n = query.surface.n;
    const dvec3& v = query.surface.v;
    const dvec3 mirror = 2.0 * glm::dot(n, v) * n - v;
    const double distance = glm::length(query.toCenter);
    const BrdfTerms middle = evaluateTerms(query.methods, litFrom(query, center));
    const BrdfTerms nearest = evaluateTerms(query.methods, litFrom(query, nearestToRay(query, mirror)));
    const double alpha = query.surface.alpha;
    const double spread = query.radius / (3.0 * std::max(distance, kLeastLightDistance));
    const double widened = std::min(alpha + spread, 1.0);
    const double energy = alpha * alpha / (widened * widened);
    return (middle.diffuse * middle.weight + nearest.specular * nearest.weight * energy) * farIrradiance(query);
}

dvec3 A_sampled(const AreaQuery& query)
{
    const double distance = glm::length(query.toCenter);
    const double angle = query.radius < distance ? std::asin(query.radius / distance) : kPi / 2.0;
    const double oneLessCosine = 2.0 * std::pow(std::sin(angle / 2.0), 2);
    const dmat3 axes = frameAround(directionOfCenter(query));
    dvec3 sum(0);
    for (int i = 0; i < query.samples; ++i) {
        const auto count = static_cast<std::uint32_t>(query.samples);
        const dvec2 u = rotatedPoint(hammersley(static_cast<std::uint32_t>(i), count), query.rotation);
        sum += evaluateTerms(query.methods, litFrom(query, axes * sampleCone(oneLessCosine, u))).response();
    }
    // The cone's solid angle times the radiance intensity / (pi radius^2), where sin^2 = 1 - cos^2 = (2 - h) h.
    return sum * farIrradiance(query) * (2.0 / ((2.0 - oneLessCosine) * query.samples));
}

} // namespace torrance::brdf
