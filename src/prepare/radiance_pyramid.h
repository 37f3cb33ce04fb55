// Radiance as a cube with plain mip levels, for methods that draw samples.
#pragma once

#include "prepare/cube_levels.h"

#include <vector>

namespace torrance {

/// Level 0 is `radiance`, 6 faces of `size` (a power of two) RGBA texels; a texel of each following level, down to one
/// a face, is the mean of the four under it, weighed by their solid angles: the energy of every level is the same.
CubeLevels radiancePyramid(const std::vector<float>& radiance, int size);

} // namespace torrance
