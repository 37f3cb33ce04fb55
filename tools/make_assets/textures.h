// The demo scene's textures. Colours are sRGB codes. All but the leaf and the numerals tile.
#pragma once

#include "make_assets/picture.h"

namespace torrance::assets {

/// Chips of stone in a pale cement.
Image terrazzoColor(int size);

/// Walnut, its grain along u.
Image woodColor(int size);

/// Metallic-roughness: smoother where the wood is dark. Metallic 0.
Image woodRoughness(int size);

/// A normal map of overlapping round dents, as a hammer leaves them.
Image hammeredNormal(int size);

/// Metallic-roughness of metal that was brushed along u. Metallic 1.
Image brushedRoughness(int size);

/// Alpha cuts round holes, six about each one; the tile is sqrt(3) times as high as wide when it is drawn in
/// proportion.
Image perforatedAlpha(int size);

/// One leaf, tip up, with its outline in alpha.
Image leafColor(int size);

/// "1967", the year of Torrance and Sparrow's paper, in glowing segments. Twice as wide as high.
Image numerals(int height);

/// A glaze that runs from light at the top to dark, with specks.
Image glazeColor(int size);

} // namespace torrance::assets
