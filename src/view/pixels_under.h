// Small pictures of large ones.
#pragma once

#include "scene/pixel_box.h"

#include <algorithm>

namespace torrance {

/// The pixels of a picture that lie under pixel (x, y) of a smaller one of it; one where the other is larger.
inline PixelBox pixelsUnder(int x, int y, const ivec2& small, const ivec2& whole)
{
    const ivec2 first = ivec2(x, y) * whole / small;
    return {first, glm::max(ivec2(x + 1, y + 1) * whole / small, first + 1)};
}

} // namespace torrance
