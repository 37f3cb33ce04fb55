// What the models of source systems make of light from an environment: one formula per model whose source defines one.
#pragma once

#include "brdf/light_query.h"

namespace torrance::brdf {

struct Preset;

/// Source E: radiance towards v. Reads n, v, radiance and perceptualRoughness of the query; R0 follows from the
/// metalness (material_mapping.h). NoV >= 0.
dvec3 environment_torrance_sparrow_blinn(const Preset& preset, EnvironmentQuery query, const dvec3& color,
                                         double metalness);

/// Source B's ggx-burley: the same, from its levels and its integration map.
dvec3 environment_ggx_burley(const Preset& preset, EnvironmentQuery query, const dvec3& base, double metalness);

/// Source B's phong: all light towards v, the environment mixed into `lit`, what the lights alone make of the surface.
/// Reads n, v and radiance of the query.
dvec3 environment_phong(const Preset& preset, const EnvironmentQuery& query, const dvec3& lit);

} // namespace torrance::brdf
