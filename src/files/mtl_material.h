// MTL's parameters as the scene's: its physically based keys as they stand, Phong's where those are missing.
#pragma once

#include "files/mtl_file.h"
#include "scene/material.h"

namespace torrance {

/// Base colour of a material that states none, and of faces without a material.
inline constexpr double kPlainBaseColor = 0.8;

/// A dielectric of kPlainBaseColor and full roughness, seen from both sides (the format knows no others): what an MTL
/// material is before it states anything.
Material plainMaterial();

/// The factors of the material; textures are left to readMtlTextures. Pr, Pm, Ke and d are taken as they are. Without
/// Pr the roughness is that of a highlight of exponent Ns (perceptualRoughnessOfShininess), and 1 where there is no
/// highlight: Ns is missing, Ks is black or illum is 0 or 1. Without Pm it is 0. Base colour is Kd, linear. Where a map
/// stands without its value, the value is 1. Sheen, coat and anisotropy are warned of. Values out of range are clamped
/// with a warning. Ni above 1 is the dielectric's index of refraction; 1, which exporters write for want of one, is
/// none.
Material materialOfMtl(const MtlMaterial& from, LoadReport& report);

} // namespace torrance
