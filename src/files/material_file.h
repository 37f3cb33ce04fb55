// One material in a file of its own: a glTF document that holds nothing else.
#pragma once

#include "scene/material.h"

#include <filesystem>
#include <string>
#include <vector>

namespace torrance {

struct LoadedMaterial
{
    Material material;                 // without textures
    std::vector<std::string> warnings; // each a line that names the file
};

/// Writes name and factors, whole or not at all; other programs read it as glTF. Returned is what was left out, each a
/// line: textures, and with them the scale of a normal map and the strength of an occlusion map. Errors (cannotWrite):
/// a value that would not read back as it is, or a file that cannot be written.
std::vector<std::string> saveMaterial(const Material& material, const std::filesystem::path& path);

/// Reads such a file, or any glTF document with one material, textures left out with a warning. Errors (input): what is
/// no glTF, holds no material or several, or comes from a later version of this format.
LoadedMaterial loadMaterial(const std::filesystem::path& path);

} // namespace torrance
