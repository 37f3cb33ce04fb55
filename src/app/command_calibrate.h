#pragma once

#include "app/command.h"

namespace torrance {

/// `torrance calibrate -o FILE`: the measured table of methods on this device.
Command calibrateCommand();

} // namespace torrance
