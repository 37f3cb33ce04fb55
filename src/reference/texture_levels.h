// Textures as a pixel sees them from afar: filtered by level of detail, in double.
#pragma once

#include "reference/texture_sampling.h"

namespace torrance {

/// How a picture's texels count where they are averaged: scene/texture.h says what they mean.
struct LevelRule
{
    TexelContent content = TexelContent::data;
    bool weighByAlpha = false; // colours count by their alpha: masked and blended materials
};

/// How texture coordinates change from the first pixel of a quad to the one on its right, and to the one below.
struct UvSteps
{
    dvec2 right = dvec2(0.0);
    dvec2 below = dvec2(0.0);
};

/// Texel (x, y) of level k, max(1, floor(size / 2^k)) wide and high: the mean of the picture over the area that the
/// texel covers, colours as light, normals made unit again ((0, 0, 1) where they cancel). What is stored as sRGB is
/// decoded where the content is colour. 0 <= x < width of the level, 0 <= y < its height.
dvec4 levelTexel(const TextureImage& image, const LevelRule& rule, int level, int x, int y);

/// log2 of the longer of both steps in texels (Vulkan 1.3, section 16.5.7, "Scale Factor Operation", without
/// anisotropy), plus `bias`. A step that is not finite counts as none; -infinity where both are none.
double levelOfDetail(const TextureImage& image, const UvSteps& steps, double bias);

/// A texture as Vulkan's sampler reads it at a level of detail (section 16.5.8 ff.): magnified at or below 0; minified,
/// from one level or from two, above it.
dvec4 sampleLevels(const TextureImage& image, const Sampler& sampler, const LevelRule& rule, const dvec2& uv,
                   double levelOfDetail);

} // namespace torrance
