// Errors as colours.
#pragma once

#include "image/image.h"

namespace torrance {

/// One channel in [0, 1] (clipped; NaN counts as 1) to display-encoded colour: black over violet and orange to pale
/// yellow, with evenly rising lightness (the map `magma` of matplotlib, by van der Walt and Smith, at nine of its
/// colours).
Image heatMap(const Image& error);

} // namespace torrance
