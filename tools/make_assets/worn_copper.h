// The maps of a material as texture libraries publish them: copper whose patina has worn off in places. They tile.
#pragma once

#include "make_assets/picture.h"

#include <filesystem>

namespace torrance::assets {

/// What the maps are drawn from, at a place of the tile; u right, v down.
struct WornCopper
{
    dvec3 color; // sRGB codes
    double roughness;
    double metallic;
    dvec3 normal;     // +Y up in the picture
    double occlusion; // share of the light that arrives
};

WornCopper wornCopper(double u, double v);

/// worn_copper_Color.png (8 bits), _Roughness and _Metalness (16 bits, grey), _NormalGL (16 bits) and _AmbientOcclusion
/// (8 bits, grey), of 512 x 512 texels.
void writeWornCopper(const std::filesystem::path& folder);

} // namespace torrance::assets
