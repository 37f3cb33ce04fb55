#include "app/commands.h"

#include "app/command_methods.h"

namespace torrance {

std::vector<Command> allCommands()
{
    return {methodsCommand()};
}

} // namespace torrance
