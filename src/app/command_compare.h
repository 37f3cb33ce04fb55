#pragma once

#include "app/command.h"

namespace torrance {

/// `torrance compare REFERENCE TEST`: how far two pictures lie apart; limits make it a check.
Command compareCommand();

} // namespace torrance
