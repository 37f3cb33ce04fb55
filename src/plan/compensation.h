// Whether a material's multiple scattering is worth computing.
#pragma once

#include "plan/material_plan.h"

namespace torrance {

/// What `scale` compensation adds to the light that a surface of the range returns under uniform light, as a fraction
/// of that light, averaged over the views with weight NoV: F0 (1/E - 1) (scale F0 + bias) against the whole albedo.
/// Taken at the range's roughest, most metallic and brightest end, and in the colour channel that gains most.
double compensationGain(const MaterialRange& range);

/// Below this the lobe is drawn without compensation: a tenth of the default tolerance of 1 %.
inline constexpr double kCompensationThreshold = 1e-3;

} // namespace torrance
