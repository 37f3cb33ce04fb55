// Mip chains of the textures that materials sample.
#pragma once

#include "scene/texture.h"

#include <vector>

namespace torrance {

/// How a texture is read, which decides how it is averaged.
struct MipRule
{
    TexelContent content = TexelContent::color;
    /// Colours count by their alpha, so that what lies hidden under the transparent part of a leaf does not bleed into
    /// its rim (Porter & Duff 1984: average premultiplied, divide again). For AlphaMode::mask and blend.
    bool weighByAlpha = false;
    /// Of normals: alpha holds the length of the mean of the unit normals, which Toksvig's filter reads. Texels of 16
    /// bits are due, made by wideNormals: 8 would round lengths near 1 by more than they differ.
    bool lengthInAlpha = false;
};

/// A normal map in 16 bits a channel with unit normals and an alpha of 1, their length.
TextureImage wideNormals(const TextureImage& normals);

/// Number of levels of a full chain: floor(log2(max(width, height))) + 1.
int mipCount(int width, int height);

/// Levels 1 and on, each max(1, floor(size / 2)) of the one before, of the format of `base` (level 0, at least 1 x 1).
/// A texel is the exact mean over the area that it covers: where a side is odd, three texels weigh in, so that nothing
/// moves (Guthe & Heckbert, Non-Power-of-Two Mipmap Creation, 2005). Means are carried on in float; only what is stored
/// is rounded.
///
/// Normals are averaged and made unit again: the lengths, which stored 8-bit channels hold to a few per cent only, are
/// not used in shading, and short vectors would be rounded by whole degrees. Opposite normals that cancel give (0, 0,
/// 1).
std::vector<TextureImage> makeMips(const TextureImage& base, const MipRule& rule);

} // namespace torrance
