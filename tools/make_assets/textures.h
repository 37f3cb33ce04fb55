// The demo scene's textures. Colours are sRGB codes. All but the leaf and the numerals tile.
#pragma once

#include "make_assets/picture.h"

namespace torrance::assets {

/// Chips of stone in a pale cement.
Picture terrazzoColor(int size);

/// Walnut, its grain along u.
Picture woodColor(int size);

/// Metallic-roughness: smoother where the wood is dark. Metallic 0.
Picture woodRoughness(int size);

/// A normal map of overlapping round dents, as a hammer leaves them.
Picture hammeredNormal(int size);

/// Metallic-roughness of metal that was brushed along u. Metallic 1.
Picture brushedRoughness(int size);

/// Alpha cuts round holes, six about each one; the tile is sqrt(3) times as high as wide when it is drawn in
/// proportion.
Picture perforatedAlpha(int size);

/// One leaf, tip up, with its outline in alpha.
Picture leafColor(int size);

/// "1967", the year of Torrance and Sparrow's paper, in glowing segments. Twice as wide as high.
Picture numerals(int height);

/// A glaze that runs from light at the top to dark, with specks.
Picture glazeColor(int size);

} // namespace torrance::assets
