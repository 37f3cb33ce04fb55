// GLSL as text: an entry file, the files that it includes, and the text that the plan writes.
#pragma once

#include "core/content_hash.h"

#include <filesystem>
#include <map>
#include <string>

namespace torrance::gpu {

/// The name under which shaders include what the plan wrote for them.
inline constexpr const char* kSelectedName = "selected.glsl";

struct ShaderSource
{
    std::string entry;                        // "passes/surface.frag": the ending names the stage
    std::map<std::string, std::string> files; // by name as included, the entry among them

    ContentHash hash() const;
};

/// Reads the entry and, recursively, every file named by an #include "..." line; names are relative to `root`.
/// `selected` stands for selected.glsl. A missing entry is an Error (usage): the installation is not whole.
ShaderSource gatherSource(const std::filesystem::path& root, const std::string& entry, const std::string& selected);

} // namespace torrance::gpu
