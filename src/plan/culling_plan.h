// Which draws' triangles are looked at before they are drawn: scene/visible_triangles.h.
#pragma once

#include "plan/shading_plan.h"

namespace torrance {

/// Sets Draw::culls of opaque and masked meshes: as the settings ask, or where a software rasterizer gains by it, and
/// says why. As choosePath(), it looks at counts alone.
void planCulling(const Scene& scene, ShadingPlan& plan);

} // namespace torrance
