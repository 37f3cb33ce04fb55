// FLIP: how different two pictures look to a person who flips between them at a given distance. Per pixel, in [0, 1].
#pragma once

#include "image/image.h"
#include "math/vector.h"

namespace torrance {

/// Pixels per degree of visual angle: a display of 3840 pixels over 0.7 m, seen from 0.7 m, as in both papers. 67.02.
inline constexpr double kFlipPixelsPerDegree = 3840.0 * kPi / 180.0;

/// LDR-FLIP. Andersson et al., FLIP: A Difference Evaluator for Alternating Images, 2020. Both pictures have 3 channels
/// of display-linear colour, clipped here to [0, 1], and one size. One channel comes back.
Image ldrFlip(const Image& reference, const Image& test, double pixelsPerDegree = kFlipPixelsPerDegree);

/// The exposures, in stops, at which HDR-FLIP looks: `count` of them, evenly from `start` to `stop`.
struct FlipExposures
{
    double start = 0.0;
    double stop = 0.0;
    int count = 1;
};

/// From the luminances of the reference (2021, section 3.2): at `start` its brightest, at `stop` its median pixel is
/// shown at 85 % of white; a stop or less apart, at least two. Where the median is black, as behind a lone object, it
/// is that of the pixels that are not; where all are black, one exposure of 0 stops stands in.
FlipExposures flipExposures(const Image& reference);

/// HDR-FLIP. Andersson et al., Visualizing Errors in Rendered High Dynamic Range Images, 2021: the largest LDR-FLIP
/// over the exposures, each shown through the paper's ACES curve. Both pictures have 3 channels of scene-linear colour
/// and one size; negative values count as 0.
Image hdrFlip(const Image& reference, const Image& test, double pixelsPerDegree = kFlipPixelsPerDegree);

} // namespace torrance
