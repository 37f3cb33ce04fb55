// From which level of detail a texture is read: the rows of slot textureFilter.
#pragma once

#include "brdf/light_query.h"
#include "brdf/method.h"

namespace torrance::brdf {

/// Of all of them 0 is the texture as it is, and each further 1 a level of half its sides; at or below 0 it is
/// magnified. -infinity where it is the same all over the quad.
double T_trilinear_exact(const TexelFootprint& footprint);
/// The same; a device's logarithm may be off.
double T_trilinear(const TexelFootprint& footprint);
/// Of texels that lie together, rounded: shaders/shared/texel_words.h.
double T_trilinear_words(const TexelFootprint& footprint);
/// Whole numbers; halfway, the finer.
double T_nearest_level(const TexelFootprint& footprint);

/// The shader computes the level; else the device does.
bool computesLevel(const Preset& methods);
/// Texels of several textures lie together where they can.
bool readsWords(const Preset& methods);
/// Of two levels the nearer alone is read.
bool readsOneLevel(const Preset& methods);

} // namespace torrance::brdf
