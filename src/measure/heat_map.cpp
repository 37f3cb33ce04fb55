#include "measure/heat_map.h"

#include "math/vector.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace torrance {
namespace {

// Codes of magma at 0, 1/8, ... 1.
constexpr std::array<std::array<int, 3>, 9> kMagma = {{{0, 0, 4},
                                                       {28, 16, 68},
                                                       {79, 18, 123},
                                                       {129, 37, 129},
                                                       {181, 54, 122},
                                                       {229, 80, 100},
                                                       {251, 135, 97},
                                                       {254, 194, 135},
                                                       {252, 253, 191}}};

vec3 colorAt(std::size_t anchor)
{
    return vec3(kMagma[anchor][0], kMagma[anchor][1], kMagma[anchor][2]) / 255.0f;
}

vec3 magma(float value)
{
    const float place = (value < 1.0f ? std::max(value, 0.0f) : 1.0f) * static_cast<float>(kMagma.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kMagma.size() - 2);
    return glm::mix(colorAt(below), colorAt(below + 1), place - static_cast<float>(below));
}

} // namespace

Image heatMap(const Image& error)
{
    assert(error.channels == 1);
    Image colors(error.width, error.height, 3);
    for (std::size_t i = 0; i < error.texels.size(); ++i) {
        const vec3 color = magma(error.texels[i]);
        std::copy_n(&color.x, 3, &colors.texels[3 * i]);
    }
    return colors;
}

} // namespace torrance
