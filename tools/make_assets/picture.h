// Pictures of eight bits a channel, as they stand in a PNG.
#pragma once

#include "math/vector.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace torrance::assets {

struct Picture
{
    int width = 0;
    int height = 0;
    int channels = 0; // 1 grey, 3 RGB, 4 RGBA
    std::vector<std::uint8_t> bytes;
};

/// Each texel from its middle (u, v), values in [0, 1] rounded to nearest. Channels beyond `channels` are left out.
Picture makePicture(int width, int height, int channels, const std::function<dvec4(double u, double v)>& texel);

} // namespace torrance::assets
