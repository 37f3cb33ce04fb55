// The demo scene as glTF 2.0.
#pragma once

#include "make_assets/chart_atlas.h"
#include "make_assets/demo_scene.h"

#include <filesystem>

namespace torrance::assets {

/// Writes `path` (.gltf) and, beside it, the .bin of the same name. The pictures that materials name lie beside them,
/// and so does `occlusion`, the atlas that every material takes its occlusion from through the second set of texture
/// coordinates.
void writeGltf(const std::filesystem::path& path, const DemoScene& scene, const std::vector<std::vector<Chart>>& charts,
               const std::string& occlusion);

} // namespace torrance::assets
