// The seven primitive modes as lists of points, lines and triangles.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace torrance {

inline constexpr int kGltfModes = 7; // POINTS .. TRIANGLE_FAN

Topology topologyOfMode(int mode);

/// How many indices unrolled() gives for `count` of them: what is allocated, known beforehand.
std::size_t unrolledCount(int mode, std::size_t count);

/// Strips, fans and loops as lists, in the winding of glTF 2.0, 3.7.2.1; indices that complete no line or triangle are
/// left out. `mode` is 0 to 6.
std::vector<std::uint32_t> unrolled(int mode, std::vector<std::uint32_t> indices);

} // namespace torrance
