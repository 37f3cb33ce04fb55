// Panoramas of a function of direction.
#pragma once

#include "math/latlong.h"
#include "scene/scene.h"

namespace torrance::test {

/// `width` x width / 2 texels, each the radiance along the direction of its centre.
template <typename Radiance> // dvec3(const dvec3& direction)
Environment panoramaOf(const Radiance& radiance, int width)
{
    Environment environment = {.name = "test", .radiance = Image(width, width / 2, 3)};
    for (int y = 0; y < width / 2; ++y)
        for (int x = 0; x < width; ++x) {
            const dvec3 value = radiance(directionFromLatLong({(x + 0.5) / width, (y + 0.5) / (width / 2)}));
            for (int c = 0; c < 3; ++c)
                environment.radiance.at(x, y)[c] = static_cast<float>(value[c]);
        }
    return environment;
}

} // namespace torrance::test
