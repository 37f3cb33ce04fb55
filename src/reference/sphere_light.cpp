#include "reference/sphere_light.h"

#include "math/frame.h"
#include "math/sampling.h"
#include "reference/punctual_light.h"

#include <algorithm>
#include <cmath>

namespace torrance {

SphereLight::SphereLight(const Light& light, const dvec3& origin, const dvec3& position)
{
    const LightSample centre = sampleLight(light, origin, position);
    const double distance = std::max(glm::length((light.position - origin) - position), kMinLightDistance);
    const double sine = std::min(1.0, light.radius / distance);
    worldFromCone = frameAround(centre.direction);
    oneLessCosine = sine * sine / (1.0 + std::sqrt(1.0 - sine * sine));
    radiance = centre.irradiance * (distance * distance / (kPi * light.radius * light.radius));
}

DirectedLight SphereLight::at(const dvec3& direction) const
{
    const dvec3 off = direction - worldFromCone[2]; // |off|^2 = 2 (1 - cos), without cancellation
    if (0.5 * glm::dot(off, off) > oneLessCosine)
        return {};
    return {radiance, 1.0 / (2.0 * kPi * oneLessCosine)};
}

dvec3 SphereLight::draw(const dvec2& u) const
{
    return worldFromCone * sampleCone(oneLessCosine, u);
}

} // namespace torrance
