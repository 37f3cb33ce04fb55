#pragma once

#include "app/command.h"

namespace torrance {

/// `torrance probe`: a shading term on the device and in double, row by row of a table.
Command probeCommand();

} // namespace torrance
