// Which way opaque and masked surfaces come to their light.
#pragma once

#include "plan/shading_plan.h"

#include <array>

namespace torrance {

/// All there are.
inline constexpr std::array kRenderPaths = {RenderPath::forward, RenderPath::prepass, RenderPath::attributes,
                                            RenderPath::deferred};

/// Sets ShadingPlan::path: the settings' own, or the one that is cheapest on a software rasterizer
/// (docs/performance.md), and says why. The rule looks at counts alone, so that all cameras see one path. For a plan
/// whose surfaces and lights are known. Error (usage) where the settings' own cannot draw what is asked for.
void choosePath(const Scene& scene, ShadingPlan& plan);

const char* nameOf(RenderPath path);

} // namespace torrance
