#include "app/commands.h"

#include "app/command_compare.h"
#include "app/command_inspect.h"
#include "app/command_methods.h"

namespace torrance {

std::vector<Command> allCommands()
{
    return {compareCommand(), inspectCommand(), methodsCommand()};
}

} // namespace torrance
