// Diffuse light from all directions: irradiance / pi as a cube, and as the nine numbers of its first harmonics.
#pragma once

#include "image/image.h"
#include "prepare/cube_tree.h"

#include <array>
#include <vector>

namespace torrance {

/// 6 faces of `size` (a multiple of kBlockSide), RGBA: the mean of base + excess under the clamped cosine, odd and
/// higher bands included: within 1e-3 of the full integral.
std::vector<float> irradianceFaces(const CubeTree& base, const CubeTree& excess, int size);

/// Coefficients of irradiance / pi of a lat-long panorama in shBasis: radiance projected texel by texel, times
/// clampedCosineBand(l) / pi (Ramamoorthi & Hanrahan 2001).
std::array<vec3, 9> irradianceHarmonics(const Image& panorama);

} // namespace torrance
