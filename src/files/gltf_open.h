// A .gltf or .glb file, opened and checked, before anything is made of it.
#pragma once

#include "files/gltf_container.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace torrance {

struct OpenedGltf
{
    std::vector<std::byte> bytes;
    GltfContainer container; // views into `bytes`
    nlohmann::json document; // passed checkVersion and checkSchema
};

/// Errors (input): of reading, of the container, of JSON, version and schema.
OpenedGltf openGltf(const std::filesystem::path& path, const std::string& file);

} // namespace torrance
