// The roughness of a pixel instead of a point's: the rows of slot specularAntialiasing.
#pragma once

#include "brdf/light_query.h"

namespace torrance::brdf {

double AA_none(const NormalFootprint& footprint);
/// From the mean normal's length alone.
double AA_toksvig(const NormalFootprint& footprint);
/// From the derivatives alone.
double AA_tokuyoshi(const NormalFootprint& footprint);

/// The paper's bound on what tokuyoshi adds to alpha^2: larger derivatives are those of silhouettes.
inline constexpr double kKernelCap = 0.18;

} // namespace torrance::brdf
