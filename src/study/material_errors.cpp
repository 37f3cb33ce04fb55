#include "study/material_errors.h"

namespace torrance {

MaterialErrors materialErrors(std::span<const PixelStratum> strata, std::span<const CoveredPixel> sample,
                              std::span<const PixelError> errors, int materials)
{
    MaterialErrors result;
    double norm = 0.0, pixels = 0.0;
    std::size_t i = 0;
    for (const PixelStratum& stratum : strata)
        for (std::size_t drawn = 0; drawn < stratum.drawn.size(); ++drawn, ++i) {
            const double weight = double(stratum.population) / double(stratum.drawn.size());
            MaterialError& own = result[sample[i].material < 0 ? materials : sample[i].material];
            own.error += weight * errors[i].middle();
            own.pixels += weight;
            norm += weight * errors[i].norm;
            pixels += weight;
        }
    for (auto& [material, own] : result) {
        own.error = norm > 0.0 ? own.error / norm : 0.0;
        own.pixels /= pixels;
    }
    return result;
}

} // namespace torrance
