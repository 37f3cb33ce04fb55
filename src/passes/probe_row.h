// A shading point as the numbers of shaders/shared/probe.h's row.
#pragma once

#include "brdf/shading_point.h"
#include "shaders/shared/probe.h"

#include <array>

namespace torrance {

/// Scalar layout has no padding, and every member is a float or a vector of floats.
inline constexpr std::size_t kProbeScalars = sizeof(shared::ProbeRow) / sizeof(float);

/// In the order of the row's members.
std::array<double, kProbeScalars> probeScalars(const brdf::ShadingPoint& point);

} // namespace torrance
