// torrance view: the window, which is a program of its own, so that this one links no window system.
#pragma once

#include "app/command.h"

namespace torrance {

/// The name of that program, beside this one.
inline constexpr const char* kWindowProgram = "torrance-view";

Command viewCommand();

} // namespace torrance
