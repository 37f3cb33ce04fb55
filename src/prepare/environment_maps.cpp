#include "prepare/environment_maps.h"

#include "math/latlong.h"

namespace torrance {

EnvironmentMaps makeEnvironmentMaps(const Image& radiance)
{
    dvec3 mean(0.0);
    for (int y = 0; y < radiance.height; ++y)
        for (int x = 0; x < radiance.width; ++x)
            for (int c = 0; c < 3; ++c)
                mean[c] +=
                    radiance.at(x, y)[c] * latLongTexelSolidAngle(y, radiance.width, radiance.height) / (4.0 * kPi);
    std::vector<float> texels;
    for (int i = 0; i < 6; ++i)
        texels.insert(texels.end(), {float(mean.x), float(mean.y), float(mean.z), 1.0f});
    const CubeLevels cube = {.size = 1, .levels = 1, .data = {texels}};
    return {.specular = cube, .irradiance = cube};
}

} // namespace torrance
