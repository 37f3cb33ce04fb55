// From the arguments of the process to its exit code.
#pragma once

#include "app/command.h"

#include <string>
#include <vector>

namespace torrance {

/// Parses `arguments` (without the program's name), runs the command they name and returns the exit code. Never throws:
/// whatever goes wrong is one line on standard error.
ExitCode runCommandLine(const std::vector<std::string>& arguments, const std::vector<Command>& commands);

} // namespace torrance
