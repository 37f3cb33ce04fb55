// What can be known of a texture without drawing it.
#pragma once

#include "scene/scene.h"

#include <array>
#include <vector>

namespace torrance {

/// Least and greatest stored value of each channel over all texels, as [0, 1] fractions of the format's range.
struct TexelFacts
{
    std::array<double, 4> least = {0, 0, 0, 0};
    std::array<double, 4> greatest = {1, 1, 1, 1};

    bool constant(int channel) const
    {
        return least[static_cast<std::size_t>(channel)] == greatest[static_cast<std::size_t>(channel)];
    }
};

TexelFacts texelFacts(const TextureImage& image);
/// Of all its images, in their order.
std::vector<TexelFacts> texelFacts(const Scene& scene);

} // namespace torrance
