// What a glTF document says that it holds.
#pragma once

#include "files/gltf_container.h"
#include "files/scene_file.h"

#include <nlohmann/json_fwd.hpp>

namespace torrance {

/// Of a document that passed checkSchema; nothing about what is drawn.
SceneFacts factsOfDocument(const nlohmann::json& document, const GltfContainer& container, std::size_t fileBytes);

/// Adds what the loaded scene draws.
void addSceneFacts(SceneFacts& facts, const Scene& scene);

} // namespace torrance
