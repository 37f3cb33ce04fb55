// How much a formula magnifies the rounding of what it is given.
#pragma once

#include "brdf/shading_point.h"

#include <functional>

namespace torrance::brdf {

/// Summed relative condition number of a formula with respect to n, v, l and r: kappa = sum over the nine components x
/// of the vectors and over r of |f(x (1 +- u)) - f(x)| / (u |f(x)|), the greater of both signs. Components are changed
/// one at a time and the vectors normalised again afterwards, as whoever is given rounded unit vectors sees them; what
/// the point holds beside its geometry stays. The greatest of the three channels; channels that are 0 count as 0.
///
/// u = 2^-24 is the rounding of a float, and not smaller: at the very peak of a narrow highlight the derivative is 0,
/// yet rounding moves the half vector off the peak. Elsewhere the step changes kappa by less than a share kappa u.
double conditionNumber(const std::function<dvec3(const ShadingPoint&)>& formula, const ShadingPoint& at);

} // namespace torrance::brdf
