// A whole file in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace torrance {

/// The largest file that is read: what the 32-bit length of a GLB can state.
inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t(1) << 32;

/// The first `most` bytes of `path`, or all of it where it is shorter. Errors (input) name `file` and `item`: missing,
/// a folder, not a regular file (a pipe would never end), unreadable, or, where `most` is kMaxFileBytes, larger.
std::vector<std::byte> readFile(const std::filesystem::path& path, const std::string& file, const std::string& item,
                                std::uint64_t most = kMaxFileBytes);

} // namespace torrance
