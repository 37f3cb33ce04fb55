#pragma once

#include "app/command.h"

namespace torrance {

/// `torrance stability`: where methods break, in 16, 32 and 64 bits.
Command stabilityCommand();

} // namespace torrance
