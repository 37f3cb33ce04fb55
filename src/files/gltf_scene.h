// From a checked document to the scene that it draws.
#pragma once

#include "files/gltf_accessors.h"
#include "files/gltf_buffers.h"
#include "files/gltf_nodes.h"
#include "files/scene_file.h"

#include <nlohmann/json_fwd.hpp>
#include <stop_token>
#include <vector>

namespace torrance {

/// A document whose structure, references and sizes were checked.
struct GltfDocument
{
    std::string stem; // names a scene that has no name
    const nlohmann::json& json;
    const GltfBuffers& buffers;
    const std::vector<GltfAccessor>& accessors;
    const GltfNodeTree& tree;
    const GltfOrigin& origin;
    const SceneLimits& limits;
    const std::stop_token& stop;
    const KnownImages& known;
};

/// The number of the scene that is drawn: `chosen`, the file's default, the first; -1 where the file has no scenes.
/// Errors: usage, where there is no scene `chosen`.
int sceneNumber(const nlohmann::json& document, const std::optional<int>& chosen, const LoadReport& report);

struct GltfScene
{
    Scene scene;
    FileItems items;
    std::vector<ContentHash> encodedImages; // as in LoadedScene
};

/// Scene `number` of the document; all root nodes where it is -1.
GltfScene buildScene(const GltfDocument& document, int number, LoadReport& report);

} // namespace torrance
