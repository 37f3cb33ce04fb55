// The three environments that the project ships.
#pragma once

#include <filesystem>

namespace torrance::assets {

/// studio.hdr, sky.hdr and furnace.hdr (radiance 1 from everywhere).
void writeEnvironments(const std::filesystem::path& folder);

} // namespace torrance::assets
