// The roughness of a pixel instead of a point's: the rows of slot specularAntialiasing.
#pragma once

#include "brdf/light_query.h"

namespace torrance::brdf {

double AA_none(const NormalFootprint& footprint);

} // namespace torrance::brdf
