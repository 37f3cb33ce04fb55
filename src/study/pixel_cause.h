// Which approximation makes one pixel wrong.
#pragma once

#include "plan/settings.h"
#include "reference/pixel_estimate.h"

#include <string>

namespace torrance {

struct PixelCause
{
    std::string slot;   // of the registry; "surface" where none explains it: texture level, edge, order of surfaces
    std::string method; // that fills it; empty for "surface"
    double share = 0.0; // of |d - c|_1 that goes away with this slot alone exact
};

/// A slot must take away this share of a pixel's error to be its cause.
inline constexpr double kLeastShare = 0.1;

/// Every method that stands in for an integral (environment_diffuse, environment_specular, dfg, area_light) is computed
/// in double by its own formula for the pixel's surfaces, and so is what it stands in for; the difference is what the
/// pixel would change by if this slot alone were exact. The slot with which it comes nearest to `exact` is the cause.
/// Specular antialiasing and the texture's level have no such pair: what they do counts as "surface".
PixelCause pixelCause(const PixelEstimator& estimator, const Settings& settings, int x, int y, const dvec3& drawn,
                      const dvec3& exact);

} // namespace torrance
