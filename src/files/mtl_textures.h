// The maps of MTL materials as textures of the scene.
#pragma once

#include "files/mtl_file.h"
#include "files/scene_file.h"

namespace torrance {

/// A material of the file and the scene's that was made of it.
struct MtlPair
{
    const MtlMaterial* from = nullptr;
    Material* to = nullptr;
};

/// Reads the maps of these materials, each file once, and appends what they become to the scene's images and textures.
/// Roughness (map_Pr, or map_Ns through perceptualRoughnessOfShininess) and metallic (map_Pm) become one picture, as do
/// map_Kd and map_d: see packChannels. map_d is alpha where its picture has one, luminance otherwise; cut-out where it
/// is 0 or 1 everywhere, blended otherwise. A grey map_bump is a height map (normalsOfHeights, -bm texels high), any
/// other and norm a normal map. -s, -o, -clamp (edge texels go on), -bm, -imfchan r g b m l are followed; other options
/// that ask for a change are warned of. Errors (input) name the MTL file, the material, the key and the picture: one
/// that is missing, damaged or outside the folder, two for one texture with different options or proportions.
void readMtlTextures(const std::vector<MtlPair>& materials, const LoadOptions& options, Scene& scene,
                     LoadReport& report);

} // namespace torrance
