// How far a picture lies from a reference, in numbers.
#pragma once

#include "image/image.h"

#include <cstddef>

namespace torrance {

/// Keeps relMSE and SMAPE finite where the reference is black: relative errors count in full above about 0.1, and fade
/// below. The value of Rousselle et al., Adaptive Rendering with Non-Local Means Filtering, 2012, and of those who
/// followed.
inline constexpr double kRelativeFloor = 0.01;
/// The same for the error of a pixel: a fraction of the reference's mean.
inline constexpr double kPixelFloor = 0.01;

struct WorstPixel
{
    int x = 0; // from the left
    int y = 0; // from the top
    double error = 0.0;
};

struct ImageMetrics
{
    double relMse = 0.0;    // mean of (t - r)^2 / (r^2 + kRelativeFloor) over all channels
    double rmse = 0.0;      // root of the mean of (t - r)^2
    double smape = 0.0;     // mean of |t - r| / (|t| + |r| + kRelativeFloor)
    double meanError = 0.0; // sum of |t - r|_1 over that of |r|_1; Inf where the reference is black and the test is not
    WorstPixel worst; // of |t - r|_1 / (|r|_1 + kPixelFloor * mean |r|_1); of |t - r|_1 where the reference is black
    std::size_t nonFiniteReference = 0; // pixels with a NaN or Inf: they count here, and nowhere else
    std::size_t nonFiniteTest = 0;
};

/// Both pictures have one size and number of channels.
ImageMetrics compareImages(const Image& reference, const Image& test);

} // namespace torrance
