// How much of the diffuse BRDF the interface above it lets through, per colour channel. Read from a point: F, FNoV,
// FNoL, lobeAlbedo.
//
// Each weight is linear in what depends on the light: given that averaged over uniform light, it is exact for an
// environment of one radiance.
#pragma once

#include "brdf/shading_point.h"

namespace torrance::brdf {

dvec3 W_fresnel_voh(const ShadingPoint& point);
dvec3 W_fresnel_nol_nov(const ShadingPoint& point);
dvec3 W_albedo_scaling(const ShadingPoint& point);

} // namespace torrance::brdf
