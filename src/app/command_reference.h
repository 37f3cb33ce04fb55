#pragma once

#include "app/command.h"

namespace torrance {

/// `torrance reference`: scenes to pictures whose shading is integrated on the processor, to a stated confidence.
Command referenceCommand();

} // namespace torrance
