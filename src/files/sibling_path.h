// Files that another file names.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace torrance {

/// The file that `name` means in a file of `folder`; `\` counts as `/`. Unless `allowExternal`, what leaves the folder
/// is an Error (input) about `file` and `item`: `..`, absolute paths, drive letters.
std::filesystem::path siblingPath(std::string_view name, const std::filesystem::path& folder, bool allowExternal,
                                  const std::string& file, const std::string& item);

} // namespace torrance
