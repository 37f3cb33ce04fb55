// Which versions of glTF are read.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace torrance {

/// glTF 2.0, 3.2: a file is readable where its minVersion, or else the major number of its version, is ours. Runs
/// before anything else is checked, so that a newer file is refused by name. Errors (input).
void checkVersion(const nlohmann::json& document, const std::string& file);

} // namespace torrance
