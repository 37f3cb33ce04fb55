// A command of the program: `torrance NAME ...`. One file per command, command_<name>.cpp.
#pragma once

#include "core/error.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace torrance {

/// What every command takes, before or after its name.
struct GlobalOptions
{
    bool quiet = false;
    bool verbose = false;
    bool noCache = false;
    std::string json;                   // file for the command's result, "-" for standard output, empty for none
    std::vector<std::string> arguments; // of the process, as they were given
};

struct Command
{
    std::string name;
    std::string description;
    std::function<void(CLI::App&)> declare;            // the command's own options
    std::function<ExitCode(const GlobalOptions&)> run; // called once, after parsing; throws Error
};

/// A command whose options are the members of a plain struct: `declare` binds them, `run` reads them.
template <typename Options>
Command makeCommand(std::string name, std::string description, void (*declare)(CLI::App&, Options&),
                    ExitCode (*run)(const Options&, const GlobalOptions&))
{
    auto options = std::make_shared<Options>();
    return {.name = std::move(name),
            .description = std::move(description),
            .declare = [options, declare](CLI::App& app) { declare(app, *options); },
            .run = [options, run](const GlobalOptions& global) { return run(*options, global); }};
}

} // namespace torrance
