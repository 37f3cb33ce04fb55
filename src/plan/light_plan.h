// The lights that can be seen at all.
#pragma once

#include "plan/remark.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace torrance {

struct LightPlan
{
    std::vector<Light> lights; // directional, then point, then spot; each kind in the scene's order
    std::array<int, 3> counts = {0, 0, 0};
};

/// Leaves out lights that are black and lights whose range ends before the scene's bounds (world).
LightPlan planLights(const Scene& scene, const dvec3& boundsMin, const dvec3& boundsMax, Remarks& remarks);

} // namespace torrance
