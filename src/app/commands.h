// Every command of the program, in the order of the help text.
#pragma once

#include "app/command.h"

#include <vector>

namespace torrance {

std::vector<Command> allCommands();

} // namespace torrance
