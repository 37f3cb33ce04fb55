#include "app/commands.h"

namespace torrance {

std::vector<Command> allCommands()
{
    return {};
}

} // namespace torrance
