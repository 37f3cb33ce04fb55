// Radiance pictures (.hdr).
#pragma once

#include "image/image.h"

#include <filesystem>

namespace torrance::assets {

/// Writes three channels of finite, non-negative values as RGBE: Ward 1991, "Real Pixels".
void writeHdr(const std::filesystem::path& path, const Image& image);

} // namespace torrance::assets
