// Where a command that writes several files puts them.
#pragma once

#include <filesystem>
#include <string>

namespace torrance {

/// The folder of this name, made where it is not there. Error (cannotWrite) where that fails.
std::filesystem::path madeFolder(const std::string& name);

} // namespace torrance
