// The light that a surface sends out by itself.
#pragma once

#include "reference/material_point.h"

namespace torrance {

/// Radiance towards every direction of the side that is seen: what the material emits, or all of what an unlit one
/// shows. The back of a single-sided surface emits nothing.
dvec3 emittedRadiance(const Scene& scene, const SurfacePoint& surface, const MaterialPoint& material);

} // namespace torrance
