// How a slot is called on the command line.
#pragma once

#include "brdf/method.h"

#include <string>

namespace torrance::brdf {

/// Such as "environment-specular".
std::string slotWord(Slot slot);

/// Such as "--environment-specular".
std::string slotOption(Slot slot);

} // namespace torrance::brdf
