// The environment as it is seen behind a scene.
#pragma once

#include "image/image.h"

#include <cstddef>
#include <span>
#include <vector>

namespace torrance {

/// Level 0 is the panorama with an alpha of 1, each following level half of the one before, down to one row: means of
/// 2 x 2 texels, of the last column or row alone where a side is odd. RGBA, top row first, level after level; only the
/// levels above 0 are kept in memory. `radiance` must outlive it.
class PanoramaTexels
{
public:
    explicit PanoramaTexels(const Image& radiance);

    int levels() const { return static_cast<int>(halves.size()) + 1; }

    /// Writes the texels that follow those of the call before.
    void next(std::span<float> rgba);

private:
    const Image& radiance;
    std::vector<Image> halves;
    std::size_t at = 0; // texel of all levels
};

} // namespace torrance
