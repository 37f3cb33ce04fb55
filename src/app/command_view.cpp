#include "app/command_view.h"

#include "app/window_options.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <unistd.h>

namespace torrance {
namespace {

// The options were read here to find what is wrong with them; the window's program reads them again.
ExitCode run(const WindowOptions&, const GlobalOptions& global)
{
    std::error_code ignored;
    const std::filesystem::path program =
        std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / kWindowProgram;
    std::vector<std::string> arguments = global.arguments;
    arguments.insert(arguments.begin(), program.string());
    std::vector<char*> pointers;
    for (std::string& argument : arguments)
        pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    execv(program.c_str(), pointers.data());
    throw Error(ExitCode::noDevice, "there is no window in this build (" + program.string() + ": " +
                                        std::strerror(errno) +
                                        "); install libglfw3-dev and libimgui-dev and build Torrance again, or use "
                                        "'torrance render'");
}

} // namespace

Command viewCommand()
{
    return makeCommand<WindowOptions>("view", "Show a scene in a window", declareWindowOptions, run);
}

} // namespace torrance
