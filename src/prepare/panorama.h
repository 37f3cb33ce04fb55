// The environment as it is seen behind a scene.
#pragma once

#include "image/image.h"

#include <vector>

namespace torrance {

/// Level 0 is the panorama with an alpha of 1, each following level half of the one before, down to one row: means of
/// 2 x 2 texels, of the last column or row alone where a side is odd. RGBA, top row first.
std::vector<Image> panoramaLevels(const Image& radiance);

} // namespace torrance
