// Pictures, samplers and textures that an edit added to a scene, written into its document.
#pragma once

#include "files/gltf_draft.h"
#include "scene/scene.h"

#include <filesystem>

namespace torrance {

/// The document's numbers of a scene's items.
struct GltfNumbers
{
    std::vector<int> materials, textures, images;
};

/// Appends what `edited` has beyond the textures and images that `numbers` knows, and adds their numbers to it.
/// `pictures` are the files of the new images: into a .glb they are copied, a .gltf in `folder` names them. Errors
/// (input): one is missing, or is no PNG, JPEG or WebP.
void appendTextures(GltfDraft& draft, GltfNumbers& numbers, const Scene& edited,
                    const std::vector<std::filesystem::path>& pictures, const std::filesystem::path& folder);

} // namespace torrance
