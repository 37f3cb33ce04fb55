// A whole file in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace torrance {

/// Files larger than this are refused: nothing that is drawn from comes near it, and reading must not exhaust memory.
inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t(4) << 30;

/// An Error (input) where the file is missing, no regular file, unreadable, empty or larger than kMaxFileBytes.
std::vector<std::byte> readFile(const std::filesystem::path& path);

} // namespace torrance
