// Scenes of OBJ files, with their MTL files.
#pragma once

#include "files/load_report.h"
#include "files/scene_file.h"

namespace torrance {

/// Whether the name of the file ends in .obj, in any case of letters.
bool isObjFile(const std::filesystem::path& path);

/// Everything in the file, in metres, +Y up. An MTL file that is missing and a material that none defines are warnings:
/// the shape is there all the same, drawn with plainMaterial. Errors (input) as for every scene. A scene number is an
/// Error (usage): the format has none.
LoadedScene loadObj(const std::filesystem::path& path, const LoadOptions& options, LoadReport& report);

/// Of a file that was not loaded: its statements only.
SceneFacts readObjFacts(const std::filesystem::path& path, const LoadOptions& options);

/// The largest OBJ file that is read: in memory its text is joined by some three times as much.
inline constexpr std::uint64_t kMaxObjBytes = std::uint64_t(1) << 30;

} // namespace torrance
