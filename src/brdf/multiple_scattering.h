// The specular lobe with the light that is scattered more than once between microfacets, per colour channel, 1/sr. Read
// from a point: single, spread, f0, bias, E, ELight, EAverage.
//
// Each is linear in single and spread. For light of one radiance from all directions, the lobe's albedo for `single`, 1
// for `spread` and EAverage for ELight give the albedo with multiple scattering, exactly.
#pragma once

#include "brdf/shading_point.h"

namespace torrance::brdf {

dvec3 M_none(const ShadingPoint& point);
dvec3 M_scale(const ShadingPoint& point);
dvec3 M_kulla_conty(const ShadingPoint& point);
dvec3 M_fdez_aguera(const ShadingPoint& point);

/// Schlick's term averaged over the hemisphere, weighted by the cosine: 2 integral of (1 - c)^5 c = 1/21.
dvec3 averageSchlick(const dvec3& f0);

} // namespace torrance::brdf
