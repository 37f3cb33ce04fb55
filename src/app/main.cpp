#include "app/command_line.h"
#include "app/commands.h"

int main(int argc, char** argv)
{
    return static_cast<int>(torrance::runCommandLine({argv + 1, argv + argc}, torrance::allCommands()));
}
