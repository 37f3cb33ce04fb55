// Files that are there whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

namespace torrance {

/// Writes to a temporary name beside `path` and renames it to `path`. On any failure the temporary file is removed,
/// `path` keeps what it held, and an Error (cannotWrite) says why. A device or pipe is written to as it is.
void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
void writeFile(const std::filesystem::path& path, std::string_view text);
/// The same of parts that follow each other.
void writeFile(const std::filesystem::path& path, std::span<const std::span<const std::byte>> parts);

/// The same, looked at before it counts: `check` gets the temporary file, whole and closed, and where it throws, that
/// is the failure. What it was given to look at has to have a name: an Error (cannotWrite) where `path` is a device or
/// pipe.
void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes,
               const std::function<void(const std::filesystem::path&)>& check);

} // namespace torrance
