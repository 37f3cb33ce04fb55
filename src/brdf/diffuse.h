// The diffuse BRDF with its base colour, 1/sr per colour channel, without the cosine and without any Fresnel weight.
// Zero where v or l is not above the surface. Read from a point: NoV, NoL, VoL, NoH, VoH, alpha,
// perceptualRoughness, baseColor.
#pragma once

#include "brdf/shading_point.h"

namespace torrance::brdf {

dvec3 Fd_lambert(const ShadingPoint& point);
dvec3 Fd_burley(const ShadingPoint& point);
dvec3 Fd_burley_renormalised(const ShadingPoint& point);
dvec3 Fd_oren_nayar(const ShadingPoint& point);
dvec3 Fd_fujii(const ShadingPoint& point);
dvec3 Fd_hammon_diffuse(const ShadingPoint& point);
dvec3 Fd_chan(const ShadingPoint& point);
dvec3 Fd_eon(const ShadingPoint& point);
dvec3 Fd_eon_approx(const ShadingPoint& point);

} // namespace torrance::brdf
