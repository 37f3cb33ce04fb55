#include "make_assets/picture.h"

#include "core/parallel.h"

namespace torrance::assets {

Image makePicture(int width, int height, int channels, const std::function<dvec4(double u, double v)>& texel)
{
    Image picture(width, height, channels);
    parallelFor(static_cast<std::size_t>(height), 8, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x) {
            const dvec4 value = texel((x + 0.5) / width, (y + 0.5) / height);
            for (int c = 0; c < channels; ++c)
                picture.at(x, y)[c] = static_cast<float>(value[c]);
        }
    });
    return picture;
}

} // namespace torrance::assets
