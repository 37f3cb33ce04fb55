// A panorama from a file, fit to light a scene.
#pragma once

#include "image/image.h"

#include <cstddef>
#include <string>
#include <vector>

namespace torrance {

struct LoadedEnvironment
{
    Image radiance;           // 3 channels, finite, not negative
    std::size_t replaced = 0; // values that were NaN, Inf or negative, and are 0 now
    std::vector<std::string> warnings;
};

/// A lat-long picture in any format that readImage knows; display-referred ones are decoded from sRGB. An Error (input)
/// where the file cannot be read whole.
LoadedEnvironment loadEnvironment(const std::string& path);

} // namespace torrance
