// How much a formula magnifies the rounding of what it is given.
#pragma once

#include "brdf/shading_point.h"

#include <functional>

namespace torrance::brdf {

/// What the condition number is taken with respect to. The vectors need not be unit: the formula normalises them.
struct Geometry
{
    dvec3 n, v, l;
    double perceptualRoughness;
};

/// Summed relative condition number: kappa = sum over the nine components x of n, v, l and over r of |x df/dx| / |f|,
/// so that rounding every input by a relative u changes f by at most kappa u to first order. Components are changed one
/// at a time and the vectors normalised again afterwards, as whoever is given rounded unit vectors sees them. The
/// greatest of the three channels; channels that are 0 count as 0. Central differences with a relative step of 2^-27,
/// good to 1e-4 for kappa up to 1e6.
double conditionNumber(const std::function<dvec3(const Geometry&)>& formula, const Geometry& at);

} // namespace torrance::brdf
