// What the mip chain of a texture means.
#pragma once

#include "scene/texture.h"

#include <algorithm>
#include <bit>

namespace torrance {

/// How a texture is read, which decides how it is averaged.
struct MipRule
{
    TexelContent content = TexelContent::color;
    /// Colours count by their alpha, so that what lies hidden under the transparent part of a leaf does not bleed into
    /// its rim (Porter & Duff 1984: average premultiplied, divide again). For AlphaMode::mask and blend.
    bool weighByAlpha = false;
    /// Of normals: alpha holds the length of the mean of the unit normals, which Toksvig's filter reads.
    bool lengthInAlpha = false;
};

/// Number of levels of a full chain: floor(log2(max(width, height))) + 1.
constexpr int mipCount(int width, int height)
{
    return std::bit_width(static_cast<unsigned>(std::max(width, height)));
}

} // namespace torrance
