#include "view/lamp_turning.h"

#include <cmath>

namespace torrance {

void turnLights(std::span<Light> lights, const dvec3& center, double degrees)
{
    const double cosine = std::cos(degrees * kPi / 180.0), sine = std::sin(degrees * kPi / 180.0);
    const auto turned = [&](const dvec3& v) {
        return dvec3(cosine * v.x + sine * v.z, v.y, cosine * v.z - sine * v.x);
    };
    for (Light& light : lights) {
        light.position = center + turned(light.position - center);
        light.direction = turned(light.direction);
    }
}

} // namespace torrance
