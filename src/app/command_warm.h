// torrance warm
#pragma once

#include "app/command.h"

namespace torrance {

Command warmCommand();

} // namespace torrance
