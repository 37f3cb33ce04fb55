// The mean light of a picture's surfaces, to which small errors in the dark are held.
#pragma once

#include "image/image.h"
#include "reference/pixel_estimate.h"

namespace torrance {

/// The mean |d|_1 of the covered pixels among an even grid of at most kNormGrid^2; 0 where none is.
double coveredMeanNorm(const PixelEstimator& estimator, const Image& drawn);

inline constexpr int kNormGrid = 48; // a side: the mean of a tenth of them is known to some per cent

} // namespace torrance
