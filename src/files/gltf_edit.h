// What an edited scene changes in its document.
#pragma once

#include "files/gltf_draft.h"
#include "files/gltf_save.h"
#include "files/gltf_textures_write.h"

namespace torrance {

struct GltfEdit
{
    const LoadedScene& loaded; // as it is in the document
    const Scene& edited;
    const GltfSaveOptions& options;
    const std::string& file; // for messages
};

/// What must hold of the two scenes before anything is done. Errors (usage).
void checkEdit(const Scene& original, const Scene& edited, const GltfSaveOptions& options);

struct GltfEdited
{
    std::vector<Material> materials;     // of the edited scene, texture uses in the document's numbers
    std::vector<int> primitiveMaterials; // of the edited scene's primitives, in the document's numbers; -1 = none
};

/// Writes materials and the primitives' choices of them; the textures have been appended and have their numbers. An
/// Error (usage) where poses of one mesh, which share its primitives in the file, were given different materials, or a
/// material samples other sets of texture coordinates than its primitive was loaded with.
GltfEdited writeEdit(GltfDraft& draft, GltfNumbers& numbers, const GltfEdit& edit);

} // namespace torrance
