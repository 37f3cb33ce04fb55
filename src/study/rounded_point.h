// What is left of a shading point where numbers have few digits.
#pragma once

#include "brdf/shading_point.h"
#include "gpu/precision.h"

namespace torrance {

/// 2^-p for p bits of mantissa: the greatest relative error of rounding to nearest.
double unitRoundoff(gpu::Precision precision);
/// The least number of full precision.
double leastNormal(gpu::Precision precision);

/// The nearest number of the precision, subnormal ones included; infinity is not reached: |x| < 65504.
double roundedTo(double x, gpu::Precision precision);

/// Roughness and colours of the surface, and what other terms told, rounded; alpha formed anew: what both sides of a
/// comparison are given.
brdf::ShadingPoint materialRounded(brdf::ShadingPoint point, gpu::Precision precision);

/// What the geometry of a point has become on a device: every cosine, sin2H and oneLessVoH rounded and moved by `units`
/// in the last place, within its range. A dot product of rounded vectors is no better than a unit.
brdf::ShadingPoint geometryRounded(brdf::ShadingPoint point, gpu::Precision precision, int units);

} // namespace torrance
