#pragma once

#include "app/command.h"

namespace torrance {

/// `torrance methods`: the registry of shading methods, as text, Markdown or JSON.
Command methodsCommand();

} // namespace torrance
