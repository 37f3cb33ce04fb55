#include "make_assets/light_directions.h"

#include "make_assets/noise.h"
#include "make_assets/panorama.h"

#include <algorithm>

namespace torrance::assets {
namespace {

/// Running sum of the light over the texels, row by row, ending with 1.
std::vector<double> cumulativeLight(const Image& panorama)
{
    std::vector<double> cumulative;
    double sum = 0.0;
    for (int y = 0; y < panorama.height; ++y)
        for (int x = 0; x < panorama.width; ++x) {
            const float* texel = panorama.at(x, y);
            sum += (texel[0] + texel[1] + texel[2]) * texelSolidAngle(panorama.width, panorama.height, y);
            cumulative.push_back(sum);
        }
    for (double& value : cumulative)
        value /= sum;
    return cumulative;
}

} // namespace

std::vector<std::vector<dvec3>> lightDirections(const Image& panorama, int sets, int count)
{
    const std::vector<double> cumulative = cumulativeLight(panorama);
    std::vector<std::vector<dvec3>> result(static_cast<std::size_t>(sets));
    for (int set = 0; set < sets; ++set)
        for (int i = 0; i < count; ++i) {
            const double part = (i + randomValue(set, i, 1)) / count;
            const auto found = std::upper_bound(cumulative.begin(), cumulative.end() - 1, part);
            const auto texel = static_cast<int>(found - cumulative.begin());
            const double u = (texel % panorama.width + randomValue(set, i, 2)) / panorama.width;
            const double v = (texel / panorama.width + randomValue(set, i, 3)) / panorama.height;
            result[static_cast<std::size_t>(set)].push_back(panoramaDirection(u, v));
        }
    return result;
}

} // namespace torrance::assets
