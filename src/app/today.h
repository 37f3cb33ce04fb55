// The date that a file of measurements bears.
#pragma once

#include <string>

namespace torrance {

/// "2026-11-27", in UTC.
std::string today();

} // namespace torrance
