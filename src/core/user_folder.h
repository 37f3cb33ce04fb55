// Where a person's programs keep what is theirs (freedesktop.org, XDG Base Directory Specification).
#pragma once

#include <filesystem>

namespace torrance {

/// "torrance" in the folder that the environment variable names, else in `underHome` of the home folder; empty where
/// neither is set.
std::filesystem::path userFolder(const char* variable, const std::filesystem::path& underHome);

} // namespace torrance
