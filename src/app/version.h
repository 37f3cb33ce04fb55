// What was built, for --version and for files that say where they come from.
#pragma once

#include <string>

namespace torrance {

/// "torrance 0.1.0 (commit, build type, compiler)".
std::string versionText();

} // namespace torrance
