// Mean, median and 99th percentile of a picture's error, from a sample of its pixels.
#pragma once

#include "study/certificate.h"
#include "study/pixel_sample.h"

#include <span>
#include <string>

namespace torrance {

/// `errors` are those of the drawn pixels, stratum by stratum. The mean's interval reaches from the lower limit of the
/// ratio whose errors are too small on average to the upper limit of that whose are too large (pixel_error.h): from
/// below symmetric, from above exp(t s / R) times R, because the sum of a few large errors is skewed to the right and
/// its logarithm less so. Percentiles lie between sorted ends of the pixels' own intervals, by rank
/// (measure/quantile_ranks.h).
ErrorNumbers errorNumbers(std::span<const PixelStratum> strata, std::span<const PixelError> errors, double meanNorm);

/// "5.27 %", or "unbounded"; and "5.27 % (3.31 % to 7.68 %)": for people.
std::string percentText(double share);
std::string boundedText(const Bounded& number);

/// Mean |c|_1 over the covered pixels.
double meanNormOf(std::span<const PixelStratum> strata, std::span<const PixelError> errors);

} // namespace torrance
