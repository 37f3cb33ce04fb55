// How far a method lies from what it stands in for: both in double.
#pragma once

#include "study/sweep_points.h"

#include <vector>

namespace torrance {

/// The methods of the same slot that `approximates` names, in its order.
std::vector<const brdf::Method*> approximatedMethods(const brdf::Method& method);

struct ModelCell
{
    double error = 0.0;    // the greatest of points and channels
    brdf::ShadingPoint at; // and where
};

/// Row by row. |a - b| / (b + 1 % of the cell's greatest b): what is dark beside a highlight does not count in full. Of
/// Fresnel terms the greatest is 1. Fresnel terms are compared with exact_dielectric at dielectrics and with
/// exact_conductor at metals.
std::vector<ModelCell> modelErrors(const brdf::Method& method, const brdf::Method& approximated, const SweepAxes& axes);

} // namespace torrance
