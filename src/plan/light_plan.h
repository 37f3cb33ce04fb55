// The lights that can be seen at all.
#pragma once

#include "plan/remark.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace torrance {

/// What a uniform block of 64 KiB holds, the size that every device has.
inline constexpr std::size_t kMostLights = 1024;

struct LightPlan
{
    std::vector<Light> lights; // directional, then point, then spot; each kind in the scene's order
    std::array<int, 3> counts = {0, 0, 0};
};

/// Leaves out lights that are black and lights whose range ends before the scene's bounds (world). Error (input)
/// where more than kMostLights are left.
LightPlan planLights(const Scene& scene, const dvec3& boundsMin, const dvec3& boundsMax, Remarks& remarks);

} // namespace torrance
