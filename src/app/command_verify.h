// `torrance verify`: holds a picture against its certificate.
#pragma once

#include "app/command.h"

namespace torrance {

Command verifyCommand();

} // namespace torrance
