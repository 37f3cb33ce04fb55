#include "make_assets/light_directions.h"

#include "make_assets/panorama.h"

#include <algorithm>

namespace torrance::assets {

LightDirections::LightDirections(const Image& panorama) : width(panorama.width), height(panorama.height)
{
    double sum = 0.0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float* texel = panorama.at(x, y);
            sum += (texel[0] + texel[1] + texel[2]) * texelSolidAngle(width, height, y);
            cumulative.push_back(sum);
        }
    for (double& value : cumulative)
        value /= sum;
}

dvec3 LightDirections::at(double s, double a, double b) const
{
    const auto found = std::upper_bound(cumulative.begin(), cumulative.end() - 1, s);
    const auto texel = static_cast<int>(found - cumulative.begin());
    return panoramaDirection((texel % width + a) / width, (texel / width + b) / height);
}

} // namespace torrance::assets
