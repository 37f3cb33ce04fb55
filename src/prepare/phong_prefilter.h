// Radiance averaged by Phong's lobes: the levels of source E (brdf/phong_levels.h).
#pragma once

#include "prepare/cube_levels.h"
#include "prepare/cube_tree.h"

namespace torrance {

/// One level of 6 faces of `size` (a multiple of kBlockSide), RGBA: the mean of base + excess under
/// (exponent + 1) / (2 pi) cos^exponent above the horizon. exponent >= 0.
std::vector<float> phongLevel(const CubeTree& base, const CubeTree& excess, int size, double exponent);

} // namespace torrance
