// Light of spheres: the rows of slot areaLight.
#pragma once

#include "brdf/light_query.h"

namespace torrance::brdf {

/// A light nearer than this (metres) shines as from this distance: 1/d^2 stays finite where a light lies on a surface.
/// The same constant stands in shaders/shared/constants.h.
inline constexpr double kLeastLightDistance = 1e-6;

/// The centre's direction for all of the light.
dvec3 A_point(const AreaQuery& query);
/// The body from the centre, the lobe from the sphere's point nearest to the mirror ray, dimmed by (alpha / alpha')^2,
/// alpha' = alpha
/// + radius / (3 distance).
dvec3 A_representative(const AreaQuery& query);
/// The mean over query.samples directions of the cone that the sphere fills.
dvec3 A_sampled(const AreaQuery& query);

} // namespace torrance::brdf
