// Texture filters of a picture, from cheap to near, each with what it changes of that very picture.
#pragma once

#include "plan/method_ladder.h"
#include "plan/settings.h"
#include "scene/scene.h"
#include "study/pixel_sample.h"

#include <functional>
#include <optional>
#include <span>

namespace torrance {

/// No table knows how far apart a texture's levels are: each filter is drawn with these settings, and its error is the
/// mean relative difference to `trilinear_exact` over these pixels, which are all that is looked at of what `draw`
/// gives. What is not nearer than something cheaper is refused. None where nothing reads two levels: every filter draws
/// the same then, and `draw` is not called. Costs are not measured (NaN). Throws what `draw` throws.
std::optional<MethodLadder> filterLadder(const Scene& scene, const Settings& settings,
                                         std::span<const CoveredPixel> pixels,
                                         const std::function<const Image&(const Settings&)>& draw);

} // namespace torrance
