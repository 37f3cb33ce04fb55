// What a certificate of shading says nothing about, as far as the picture has it.
#pragma once

#include "reference/pixel_estimate.h"

#include <span>
#include <string>
#include <vector>

namespace torrance {

/// A line each: the effect, and what shows that it is there. Rays from the surfaces under `places` (pixels from the
/// picture's top-left corner) look for lamps that a surface hides and for surfaces that others see.
/// `samplingIsVouched`, `transportIsVouched`: the certificate has that part.
std::vector<std::string> unvouchedEffects(const PixelEstimator& estimator, bool samplingIsVouched,
                                          bool transportIsVouched, std::span<const dvec2> places);

} // namespace torrance
