#include "make_assets/noise.h"
#include "make_assets/textures.h"

#include <algorithm>

namespace torrance::assets {

Image glazeColor(int size)
{
    return makePicture(size, size, 3, [](double u, double v) {
        const double run = v + 0.10 * (cloudNoise(u * 5, v * 2, 5, 2, 91) - 0.5);
        dvec3 color = glm::mix(dvec3(0.13, 0.40, 0.42), dvec3(0.04, 0.20, 0.25), std::clamp(run * 1.3, 0.0, 1.0));
        const NearestPoints near = nearestPoints(u * 60, v * 60, 60, 92);
        const double radius = 0.05 + 0.16 * randomValue(near.cellX, near.cellY, 95);
        const double speck =
            randomValue(near.cellX, near.cellY, 94) < 0.4 ? std::clamp((radius - near.first) * 9.0, 0.0, 1.0) : 0.0;
        color = glm::mix(color, dvec3(0.62, 0.60, 0.50), 0.75 * speck);
        return dvec4(color, 1.0);
    });
}

} // namespace torrance::assets
