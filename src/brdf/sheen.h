// Sheen: the lobe of fibres that stand up from cloth, 1/sr, of white fibres. Read from a point: NoV, NoL, NoH, sin2H
// and alpha, the square of the sheen's roughness. 0 where v or l is not above the surface.
#pragma once

#include "brdf/shading_point.h"

namespace torrance::brdf {

double S_charlie(const ShadingPoint& point);
double S_ashikhmin(const ShadingPoint& point);

} // namespace torrance::brdf
