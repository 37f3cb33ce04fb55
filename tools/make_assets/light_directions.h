// Directions in proportion to the light that comes from them.
#pragma once

#include "image/image.h"
#include "math/vector.h"

#include <vector>

namespace torrance::assets {

/// `sets` different sets of `count` directions. Each is spread evenly over the panorama's light: every direction stands
/// for the same part of it.
std::vector<std::vector<dvec3>> lightDirections(const Image& panorama, int sets, int count);

} // namespace torrance::assets
