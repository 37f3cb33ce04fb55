// torrance devices: what Vulkan devices this machine has.
#pragma once

#include "app/command.h"

namespace torrance {

Command devicesCommand();

} // namespace torrance
