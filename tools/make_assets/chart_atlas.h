// Where each surface's chart lies in the one occlusion picture.
#pragma once

#include "make_assets/demo_scene.h"

#include <vector>

namespace torrance::assets {

inline constexpr int kAtlasSize = 512; // texels

/// A chart for each part of each object, apart from each other by `kChartGap` texels. Throws std::runtime_error where
/// they do not fit.
std::vector<std::vector<Chart>> layOutCharts(const std::vector<DemoObject>& objects);

} // namespace torrance::assets
