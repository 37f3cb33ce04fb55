// The demo scene's files.
#pragma once

#include "image/image.h"

#include <filesystem>

namespace torrance::assets {

/// demo.gltf, demo.bin and their pictures. The occlusion is baked in the light of `panorama`.
void writeDemo(const std::filesystem::path& folder, const Image& panorama);

} // namespace torrance::assets
