// The shape of a glTF document: which property is of which type, and what it may refer to.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace torrance {

/// Checks every property that the loader reads: its type, its length, its range where one is demanded for safety, and
/// that every reference lies inside the array that it points into. Whole numbers written as 4.0 become integers,
/// numbers written as 4 become doubles, so that who reads next need not care. Properties that the loader does not know,
/// and `extras`, are removed: nothing behind this check sees what it has not passed. Errors (input) give the place as a
/// JSON pointer.
void checkSchema(nlohmann::json& document, const std::string& file);

} // namespace torrance
