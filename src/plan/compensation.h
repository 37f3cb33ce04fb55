// Whether a material's multiple scattering is worth computing.
#pragma once

#include "plan/material_plan.h"

namespace torrance {

/// The most that `scale` compensation changes the directional albedo of any surface in the range, over all views, as a
/// fraction of that albedo: F0 (1/E - 1) (scale F0 + bias) / whole albedo. Bounds are taken at the range's ends.
double compensationGain(const MaterialRange& range);

/// Below this the lobe is drawn without compensation: a tenth of the default tolerance of 1 %.
inline constexpr double kCompensationThreshold = 1e-3;

} // namespace torrance
