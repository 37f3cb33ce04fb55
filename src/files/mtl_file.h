// The materials of an MTL file, as they stand in it.
#pragma once

#include "files/load_report.h"
#include "files/tinyobjloader.h"

#include <filesystem>
#include <set>

namespace torrance {

struct MtlMaterial
{
    std::string name;
    std::string file;           // the MTL file, for messages
    std::set<std::string> keys; // that it states
    tinyobj::material_t values; // of those; the others hold tinyobjloader's defaults

    bool has(const std::string& key) const { return keys.contains(key); }
};

/// Errors (input): what readMtlText refuses, an MTL file larger than kMaxMtlBytes.
std::vector<MtlMaterial> readMtlFile(const std::filesystem::path& path, LoadReport& report);

/// Some 100 bytes a line: a million of them.
inline constexpr std::uint64_t kMaxMtlBytes = std::uint64_t(100) << 20;

} // namespace torrance
