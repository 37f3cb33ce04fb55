// The factor on the specular lobe that stands for light scattered more than once between microfacets, per colour
// channel. Read from a point: f0, and E, the lobe's directional albedo with F = 1 at NoV.
#pragma once

#include "brdf/shading_point.h"

namespace torrance::brdf {

dvec3 M_none(const ShadingPoint& point);
dvec3 M_scale(const ShadingPoint& point);

} // namespace torrance::brdf
