// Where the shaders of this program lie, and whether they are its own.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace torrance::gpu {

/// A header of shaders/shared as it was when the program was built.
struct SharedHeader
{
    std::string_view name;
    std::string_view text;
};

/// All of them, by name; written while building (embed_shared.cmake).
std::span<const SharedHeader> sharedHeaders();

/// <dataFolder()>/shaders. An Error (usage) names the first header in it that is not as the program was built with:
/// what the two would tell each other lies elsewhere then, and a driver ends in undefined behaviour.
std::filesystem::path shaderFolder();

} // namespace torrance::gpu
