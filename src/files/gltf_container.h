// The two forms in which glTF comes: JSON text, or a GLB that holds the text and one binary chunk (glTF 2.0, chapter
// 4).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace torrance {

/// Views into the bytes that were split.
struct GltfContainer
{
    std::string_view json;
    std::optional<std::span<const std::byte>> binary = {}; // the BIN chunk of a GLB
    std::span<const std::byte> furtherChunks = {};         // of a GLB, headers and all: they belong to extensions
    bool isBinary = false;
};

/// Tells the forms apart by the first four bytes. Errors (input): empty, neither form, a GLB of another version, with
/// wrong lengths, truncated, or whose first chunk is not JSON.
GltfContainer splitContainer(std::span<const std::byte> bytes, const std::string& file);

} // namespace torrance
