// Opens the window that `torrance view` asks for.
#pragma once

#include "app/command.h"

namespace torrance {

/// `view` as the window's own program has it.
Command windowCommand();

} // namespace torrance
