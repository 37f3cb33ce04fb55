// Textures as glTF defines them, in double, at level 0: the wrap modes of both axes, nearest or bilinear, sRGB decoded
// per texel and before the filter, KHR_texture_transform.
#pragma once

#include "scene/scene.h"

#include <array>

namespace torrance {

enum class ColorSpace
{
    linear,
    srgb, // of the first three channels; alpha is linear always
};

/// The index in [0, size) that a texel index outside it stands for. size > 0.
int wrapIndex(long long index, int size, Wrap wrap);

/// One stored texel, normalised to [0, 1] and decoded. 0 <= x < width, 0 <= y < height.
dvec4 texelAt(const TextureImage& image, int x, int y, ColorSpace space);

/// Texel centres lie at (i + 0.5) / size. A coordinate that is not finite counts as 0.
dvec4 sampleImage(const TextureImage& image, const Sampler& sampler, const dvec2& uv, ColorSpace space);

/// A use's texture coordinates out of a point's two.
dvec2 usedUv(const TextureUse& use, const std::array<dvec2, 2>& uvs);

/// A material's use of a texture at a point's two texture coordinates, through the use's transform; all ones where no
/// texture is used. The sampler's magnification filter applies.
dvec4 sampleUse(const Scene& scene, const TextureUse& use, const std::array<dvec2, 2>& uvs, ColorSpace space);

} // namespace torrance
