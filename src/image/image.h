// A picture in memory: scene-linear float, interleaved channels, top row first.
#pragma once

#include <cstddef>
#include <vector>

namespace torrance {

struct Image
{
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<float> texels; // width * height * channels

    Image() = default;
    Image(int w, int h, int c, float fill = 0.0f)
        : width(w), height(h), channels(c),
          texels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * static_cast<std::size_t>(c), fill)
    {
    }

    float* at(int x, int y)
    {
        return texels.data() +
               (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels);
    }
    const float* at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
};

} // namespace torrance
