// A cube map with its mip levels on the host, ready for upload.
#pragma once

#include <cstddef>
#include <vector>

namespace torrance {

/// data[level] holds 6 faces (+X -X +Y -Y +Z -Z, math/cube.h) of n x n RGBA float texels, n = size >> level, top row
/// first.
struct CubeLevels
{
    int size = 0;
    int levels = 0;
    std::vector<std::vector<float>> data;

    int sizeOf(int level) const { return size >> level; }
};

/// Number of the texel in a level of faces of `size`; its four floats begin at four times that.
inline std::size_t cubeTexelIndex(int face, int x, int y, int size)
{
    const auto n = static_cast<std::size_t>(size);
    return (static_cast<std::size_t>(face) * n + static_cast<std::size_t>(y)) * n + static_cast<std::size_t>(x);
}

} // namespace torrance
