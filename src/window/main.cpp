// The window's program: `torrance view` runs it.
#include "app/command_line.h"
#include "window/window_command.h"

int main(int argc, char** argv)
{
    return static_cast<int>(torrance::runCommandLine({argv + 1, argv + argc}, {torrance::windowCommand()}));
}
