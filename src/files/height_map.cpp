#include "files/height_map.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

int neighbour(int i, int size, Wrap wrap)
{
    return wrap == Wrap::clampToEdge ? std::clamp(i, 0, size - 1) : (i + size) % size;
}

} // namespace

TextureImage normalsOfHeights(const TextureImage& heights, Channel channel, double height, Wrap wrap)
{
    TextureImage normals;
    normals.name = heights.name;
    normals.width = heights.width;
    normals.height = heights.height;
    normals.format = TexelFormat::rgba16;
    normals.texels.resize(static_cast<std::size_t>(normals.width) * static_cast<std::size_t>(normals.height) *
                          bytesPerTexel(normals.format));
    const auto at = [&](int x, int y) {
        return height *
               texelValue(heights, neighbour(x, heights.width, wrap), neighbour(y, heights.height, wrap), channel);
    };
    parallelFor(static_cast<std::size_t>(normals.height), 16, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < normals.width; ++x) {
            const double slopeX = 0.5 * (at(x + 1, y) - at(x - 1, y));
            const double slopeY = 0.5 * (at(x, y - 1) - at(x, y + 1)); // rows run downwards
            const double length = std::sqrt(slopeX * slopeX + slopeY * slopeY + 1.0);
            storeTexel(normals, x, y,
                       {0.5 - 0.5 * slopeX / length, 0.5 - 0.5 * slopeY / length, 0.5 + 0.5 / length, 1.0});
        }
    });
    return normals;
}

} // namespace torrance
