#pragma once

#include "app/command.h"

namespace torrance {

/// `torrance conform`: what a device draws against what the processor computes, as JUnit XML and HTML.
Command conformCommand();

} // namespace torrance
