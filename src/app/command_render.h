// torrance render: scenes to pictures.
#pragma once

#include "app/command.h"

namespace torrance {

Command renderCommand();

} // namespace torrance
