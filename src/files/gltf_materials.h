// Materials of glTF as materials of the scene.
#pragma once

#include "files/load_report.h"
#include "scene/material.h"

#include <array>

namespace tinygltf {
class Model;
}

namespace torrance {

struct GltfMaterial
{
    Material material;                             // texture uses: numbers of the file's textures, uvSet 0 or 1
    std::array<int, 2> uvSets = {0, 1};            // the file's sets that these are
    std::array<bool, 2> textured = {false, false}; // which of them a texture uses
};

/// Material `index` of the file. Factors outside their range are clamped with a warning. KHR_texture_transform becomes
/// a matrix, its texCoord replaces the texture's own. A material may sample any two sets of texture coordinates; a
/// third is an Error (input), as is an unknown alphaMode.
GltfMaterial readMaterial(const tinygltf::Model& model, std::size_t index, LoadReport& report);

} // namespace torrance
