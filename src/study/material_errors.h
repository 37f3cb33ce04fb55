// What each material has of a picture's error.
#pragma once

#include "plan/material_choice.h"
#include "study/pixel_error.h"
#include "study/pixel_sample.h"

#include <span>

namespace torrance {

/// Of a stratified sample: errors[i] is that of sample[i], in the strata's order. A pixel is its first surface's; of a
/// scene of `materials` materials, that number is the default one's.
MaterialErrors materialErrors(std::span<const PixelStratum> strata, std::span<const CoveredPixel> sample,
                              std::span<const PixelError> errors, int materials);

} // namespace torrance
