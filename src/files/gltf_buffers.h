// The bytes behind buffers and buffer views.
#pragma once

#include "files/gltf_container.h"
#include "files/load_report.h"

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace torrance {

/// Where data outside the document may come from.
struct GltfOrigin
{
    std::filesystem::path folder; // of the .gltf or .glb file
    bool allowExternal = false;
};

struct GltfBufferView
{
    std::span<const std::byte> bytes;
    std::size_t offset = 0; // of the view in its buffer: alignment counts from there
    std::size_t stride = 0; // 0 = elements are packed
};

/// Owns what the views look at, besides the GLB's own bytes, which the caller keeps.
struct GltfBuffers
{
    std::vector<std::vector<std::byte>> storage;
    std::vector<GltfBufferView> views;
    std::uint64_t totalBytes = 0; // byteLength of all buffers that some view uses
};

/// Reads every buffer that a view of `document` uses (checked by checkSchema). A source may be longer than byteLength
/// says, as glTF allows, never shorter. Errors (input): a source missing, refused, too short or a folder, a view that
/// leaves its buffer or has an impossible stride.
GltfBuffers readBuffers(const nlohmann::json& document, const GltfContainer& container, const GltfOrigin& origin,
                        const LoadReport& report);

} // namespace torrance
