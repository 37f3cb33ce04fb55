// Whether a document that was written reads back as what was saved.
#pragma once

#include "files/gltf_textures_write.h"
#include "files/scene_file.h"

namespace torrance {

struct GltfExpectation
{
    const Scene& edited;
    const GltfNumbers& numbers;      // of the document that was written
    const FileItems& items;          // of the one that was read
    std::vector<Material> materials; // of the edited scene; textures and sets of coordinates in the document's numbers
    std::vector<int> primitiveMaterials; // of the edited scene's primitives, in the document's numbers; -1 = none
};

/// The uses of a material in a document's numbers: of textures, and of the sets TEXCOORD_n.
Material inFileNumbers(Material material, const std::vector<int>& textures, const std::array<int, 2>& uvSets);

bool sameGeometry(const Primitive& a, const Primitive& b);
bool sameTexels(const TextureImage& a, const TextureImage& b);

/// Loads `written` and compares: every material field by field, drawn or not; of every primitive its material and what
/// it is made of; samplers and texels of all textures that are drawn. An Error (cannotWrite) about `target` names the
/// first thing that differs.
void checkSaved(const std::filesystem::path& written, const LoadOptions& options, const GltfExpectation& expected,
                const std::string& target);

} // namespace torrance
