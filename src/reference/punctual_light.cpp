#include "reference/punctual_light.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

/// KHR_lights_punctual, "Range Property": 1 / d^2 inside a window that reaches zero at the range.
double distanceAttenuation(double range, double distance)
{
    const double ratio = range > 0.0 ? distance / range : 0.0;
    return std::clamp(1.0 - ratio * ratio * ratio * ratio, 0.0, 1.0) /
           std::max(distance * distance, kMinLightDistance * kMinLightDistance);
}

/// KHR_lights_punctual, "Inner and Outer Cone Angles".
double coneAttenuation(const Light& light, const dvec3& towardsLight)
{
    const double cosOuter = std::cos(light.outerConeAngle);
    const double scale = 1.0 / std::max(kLeastConeWidth, std::cos(light.innerConeAngle) - cosOuter);
    const double along = glm::dot(light.direction, -towardsLight);
    const double falloff = std::clamp((along - cosOuter) * scale, 0.0, 1.0);
    return falloff * falloff;
}

} // namespace

LightSample sampleLight(const Light& light, const dvec3& origin, const dvec3& position)
{
    if (light.kind == Light::Kind::directional)
        return {-glm::normalize(light.direction), light.color * light.intensity};
    const dvec3 toLight = (light.position - origin) - position;
    const double distance = glm::length(toLight);
    LightSample sample;
    if (!(distance > 0.0))
        return sample;
    sample.direction = toLight / distance;
    const double cone = light.kind == Light::Kind::spot ? coneAttenuation(light, sample.direction) : 1.0;
    sample.irradiance = light.color * (light.intensity * distanceAttenuation(light.range, distance) * cone);
    return sample;
}

} // namespace torrance
