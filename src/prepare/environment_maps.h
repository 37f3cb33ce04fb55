// Light from all around, made ready for the device.
#pragma once

#include "image/image.h"
#include "math/vector.h"

#include <array>
#include <vector>

namespace torrance {

/// A cube and its smaller levels: per level six faces in Vulkan's order, row by row, RGBA.
struct CubeLevels
{
    int size = 0;   // of a face of level 0
    int levels = 0; // each half of the one before
    std::vector<std::vector<float>> data;
};

struct EnvironmentMaps
{
    CubeLevels specular;   // level i prefiltered for alpha = (101^(i / (levels - 1)) - 1) / 100
    CubeLevels irradiance; // one level: irradiance / pi
};

EnvironmentMaps makeEnvironmentMaps(const Image& radiance);

} // namespace torrance
