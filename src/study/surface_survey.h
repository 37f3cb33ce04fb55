// Which surfaces a picture shows, and about how much of its light each of them sends by which way.
#pragma once

#include "plan/method_ladder.h"
#include "reference/pixel_estimate.h"
#include "study/pixel_sample.h"

#include <span>
#include <vector>

namespace torrance {

/// What the centres of these pixels see. The light of an environment is taken for even, of its mean radiance; shares
/// are of the sum of all light so estimated: what is emitted, and sent by lamps, counts in the sum alone.
std::vector<SeenSurface> surveySurfaces(const PixelEstimator& estimator, const brdf::Preset& methods,
                                        std::span<const CoveredPixel> pixels);

} // namespace torrance
