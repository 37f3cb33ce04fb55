// The errors of a sweep as a picture.
#pragma once

#include "image/image.h"
#include "study/sweep_points.h"

#include <span>
#include <string>

namespace torrance {

/// Display-encoded. Cosines rise to the right, rows upwards; a cell is a square, and beside the map stands a bar of its
/// colours. The colour is the logarithm of the error, from 1e-8 (black, and all below) to 1 (pale yellow, and all
/// above); what is not finite is blue.
Image errorMap(std::span<const double> errors, const SweepAxes& axes);

/// What the picture's axes and colours mean.
std::string errorMapLegend(brdf::Slot slot, const SweepAxes& axes);

} // namespace torrance
