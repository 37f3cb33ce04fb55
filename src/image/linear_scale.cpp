#include "image/linear_scale.h"

#include <algorithm>
#include <cmath>

namespace torrance {

double greatestValue(const Image& image)
{
    const auto channels = static_cast<std::size_t>(image.channels);
    float greatest = 0.0f;
    for (std::size_t i = 0; i < image.texels.size(); ++i)
        if (i % channels < 3 && std::isfinite(image.texels[i]))
            greatest = std::max(greatest, image.texels[i]);
    return static_cast<double>(greatest);
}

Image scaled(const Image& premultiplied, double factor, double offset)
{
    Image result = premultiplied;
    const auto channels = static_cast<std::size_t>(result.channels);
    for (std::size_t i = 0; i < result.texels.size(); i += channels) {
        const double coverage = channels > 3 ? static_cast<double>(result.texels[i + 3]) : 1.0;
        for (std::size_t c = 0; c < std::min<std::size_t>(channels, 3); ++c)
            result.texels[i + c] =
                static_cast<float>(factor * static_cast<double>(result.texels[i + c]) + offset * coverage);
    }
    return result;
}

} // namespace torrance
