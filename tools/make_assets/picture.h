// Pictures from a function of place.
#pragma once

#include "image/image.h"
#include "math/vector.h"

#include <functional>

namespace torrance::assets {

/// Each texel from its middle (u, v); values in [0, 1] as a PNG's codes stand for them. The first `channels` (1, 3 or
/// 4) are kept.
Image makePicture(int width, int height, int channels, const std::function<dvec4(double u, double v)>& texel);

} // namespace torrance::assets
