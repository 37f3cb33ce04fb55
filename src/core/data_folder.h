// Where the program's own data lies: share/torrance beside bin, in the build tree as in an installed one.
#pragma once

#include <filesystem>

namespace torrance {

/// TORRANCE_DATA, or <folder of the executable>/../share/torrance. An Error (usage) says so where it is not there.
std::filesystem::path dataFolder();

} // namespace torrance
