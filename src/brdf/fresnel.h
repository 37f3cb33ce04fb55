// F: share of light that a flat interface reflects, per colour channel, at the cosine VoH. Read from a point: VoH,
// oneLessVoH and what the method needs of f0, f90, f82, ior, eta, k.
#pragma once

#include "brdf/shading_point.h"

namespace torrance::brdf {

dvec3 F_schlick(const ShadingPoint& point);
dvec3 F_sg(const ShadingPoint& point);
dvec3 F_f82(const ShadingPoint& point);
dvec3 F_lazanyi(const ShadingPoint& point);
dvec3 F_exact_dielectric(const ShadingPoint& point);
dvec3 F_exact_conductor(const ShadingPoint& point);

} // namespace torrance::brdf
