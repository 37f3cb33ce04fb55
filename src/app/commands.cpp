#include "app/commands.h"

#include "app/command_compare.h"
#include "app/command_methods.h"

namespace torrance {

std::vector<Command> allCommands()
{
    return {compareCommand(), methodsCommand()};
}

} // namespace torrance
