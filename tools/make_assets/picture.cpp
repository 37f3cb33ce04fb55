#include "make_assets/picture.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>

namespace torrance::assets {

Picture makePicture(int width, int height, int channels, const std::function<dvec4(double u, double v)>& texel)
{
    Picture picture{width, height, channels, {}};
    picture.bytes.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                         static_cast<std::size_t>(channels));
    parallelFor(static_cast<std::size_t>(height), 8, [&](std::size_t y) {
        std::uint8_t* out = picture.bytes.data() + y * static_cast<std::size_t>(width * channels);
        for (int x = 0; x < width; ++x) {
            const dvec4 value = texel((x + 0.5) / width, (static_cast<double>(y) + 0.5) / height);
            for (int c = 0; c < channels; ++c)
                *out++ = static_cast<std::uint8_t>(std::lround(std::clamp(value[c], 0.0, 1.0) * 255.0));
        }
    });
    return picture;
}

} // namespace torrance::assets
