#pragma once

#include "app/command.h"

namespace torrance {

/// `torrance chart -o DIR`: every shading method's cost against its error; with a scene, those of whole plans.
Command chartCommand();

} // namespace torrance
