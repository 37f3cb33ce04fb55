#pragma once

#include "app/command.h"

namespace torrance {

/// `torrance inspect FILE...`: what glTF and OBJ files hold and need, and whether they can be drawn.
Command inspectCommand();

} // namespace torrance
