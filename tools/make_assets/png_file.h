// Portable network graphics.
#pragma once

#include "make_assets/picture.h"

#include <filesystem>

namespace torrance::assets {

void writePng(const std::filesystem::path& path, const Picture& picture);

} // namespace torrance::assets
