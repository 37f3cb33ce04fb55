#pragma once

#include "app/command.h"

namespace torrance {

/// `torrance chart SCENE...`: what a frame costs, and how sure that is; what more of something costs; whether memory
/// grows.
Command chartCommand();

} // namespace torrance
