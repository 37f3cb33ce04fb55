#include "study/pixel_effort.h"

#include "math/replicates.h"

#include <algorithm>
#include <cmath>

namespace torrance {

std::vector<int> directionsFor(std::span<const PixelSpread> pixels, double noise, int least, int step)
{
    double norms = 0.0, shares = 0.0;
    for (const PixelSpread& pixel : pixels) {
        norms += pixel.norm;
        shares += std::cbrt(pixel.variance); // s^(2/3)
    }
    // n_i = k s_i^(2/3) gives the sum of s_i / sqrt(n_i) the value shares / sqrt(k).
    const double root = norms > 0.0 ? kStudent95 * shares / (noise * norms) : 0.0;
    const double factor = std::min(root * root, shares > 0.0 ? kMostDirectionsInAll / shares : 0.0);
    std::vector<int> directions;
    for (const PixelSpread& pixel : pixels) {
        const double wanted = std::min(factor * std::cbrt(pixel.variance), kMostDirectionsInAll);
        directions.push_back(std::max(least, static_cast<int>(std::ceil(wanted / step)) * step));
    }
    return directions;
}

} // namespace torrance
