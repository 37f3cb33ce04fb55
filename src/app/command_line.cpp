#include "app/command_line.h"

#include "app/driver_text.h"
#include "app/version.h"
#include "core/log.h"
#include "core/nearest_name.h"
#include "core/standard_output.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <new>
#include <span>

namespace torrance {
namespace {

// Bound on the program and on every command, so that the help of both lists them.
void declareGlobalOptions(CLI::App& app, GlobalOptions& global)
{
    app.add_flag("--quiet", global.quiet, "Print errors only")->group("Everywhere");
    app.add_flag("--verbose", global.verbose, "Print what is being done and how long it takes")->group("Everywhere");
    app.add_flag("--no-cache", global.noCache, "Neither read nor write the caches on disk")->group("Everywhere");
    app.add_option("--json", global.json, "Write the result as JSON ('-': standard output)")
        ->type_name("FILE")
        ->group("Everywhere");
    app.set_version_flag("--version", versionText, "Print the version, the build and the Vulkan driver")
        ->group("Everywhere");
}

void checkGlobalOptions(const GlobalOptions& global)
{
    if (global.quiet && global.verbose)
        throw usageError("--quiet and --verbose exclude each other", "give one of them");
}

std::string suggestion(const std::string& unknown, const std::vector<std::string>& known, const std::string& otherwise)
{
    const std::string nearest = nearestName(unknown, known);
    return nearest.empty() ? otherwise : "did you mean " + nearest + "?";
}

std::vector<std::string> optionNames(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
        for (const std::string& name : option->get_snames())
            names.push_back("-" + name);
    }
    return names;
}

std::vector<std::string> commandNames(const std::vector<Command>& commands)
{
    std::vector<std::string> names;
    for (const Command& command : commands)
        names.push_back(command.name);
    return names;
}

bool looksLikeOption(const std::string& argument)
{
    return argument.size() > 1 && argument[0] == '-';
}

Error unknownOption(const CLI::App& app, const std::string& argument, const std::string& help)
{
    const std::string name = argument.substr(0, argument.find('='));
    return usageError("unknown option " + name, suggestion(name, optionNames(app), help + " lists the options"));
}

Error unknownCommand(const std::string& name, const std::vector<Command>& commands)
{
    return usageError("unknown command " + name,
                      suggestion(name, commandNames(commands), "torrance --help lists them"));
}

// CLI11 complains of what is missing before what is misspelt, though the second is mostly why the first is missing.
Error betterError(const CLI::App& program, const std::vector<Command>& commands, const CLI::ParseError& error)
{
    for (const CLI::App* command : program.get_subcommands()) {
        const std::string help = "torrance " + command->get_name() + " --help";
        for (const std::string& argument : command->remaining())
            if (looksLikeOption(argument))
                return unknownOption(*command, argument, help);
        if (!command->remaining().empty())
            return usageError("unexpected argument " + command->remaining().front(), help + " shows what it takes");
        return usageError(error.what(), help + " shows what it takes");
    }
    for (const std::string& argument : program.remaining())
        return looksLikeOption(argument) ? unknownOption(program, argument, "torrance --help")
                                         : unknownCommand(argument, commands);
    return usageError(error.what(), "torrance --help shows what it takes");
}

void declareProgram(CLI::App& program, GlobalOptions& global, const std::vector<Command>& commands)
{
    program.name("torrance");
    program.require_subcommand(1);
    declareGlobalOptions(program, global);
    for (const Command& command : commands) {
        CLI::App* sub = program.add_subcommand(command.name, command.description);
        command.declare(*sub);
        declareGlobalOptions(*sub, global);
    }
}

std::vector<const CLI::App*> allApps(const CLI::App& program)
{
    std::vector<const CLI::App*> apps = {&program};
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        apps.push_back(command);
    return apps;
}

bool takesValue(const CLI::App& program, const std::string& argument)
{
    for (const CLI::App* app : allApps(program))
        for (const CLI::Option* option : app->get_options())
            if (looksLikeOption(argument) && option->check_name(argument) && option->get_items_expected_max() > 0)
                return true;
    return false;
}

// `torrance -o a.png render a.glb` is `torrance render -o a.png a.glb`: options may stand before the command's name,
// too. A word that an option takes as its value is no command.
void moveCommandToFront(std::vector<std::string>& arguments, const CLI::App& program,
                        const std::vector<Command>& commands)
{
    const std::vector<std::string> names = commandNames(commands);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const bool isValue = i > 0 && takesValue(program, arguments[i - 1]);
        if (isValue || std::find(names.begin(), names.end(), arguments[i]) == names.end())
            continue;
        const auto place = arguments.begin() + static_cast<std::ptrdiff_t>(i);
        std::rotate(arguments.begin(), place, place + 1);
        return;
    }
}

/// Null where the arguments asked for text only (help, version), which is then printed.
const Command* parse(CLI::App& program, std::vector<std::string> arguments, const std::vector<Command>& commands)
{
    moveCommandToFront(arguments, program, commands);
    std::reverse(arguments.begin(), arguments.end()); // CLI11 takes them from the back
    try {
        program.parse(std::move(arguments));
    } catch (const CLI::CallForHelp&) {
        writeStandardOutput(program.help()); // of the command, where one was named
        return nullptr;
    } catch (const CLI::CallForVersion&) {
        writeStandardOutput(versionText() + "\n" + driverText());
        return nullptr;
    } catch (const CLI::ParseError& error) {
        throw betterError(program, commands, error);
    }
    const std::string name = program.get_subcommands().front()->get_name();
    return &*std::find_if(commands.begin(), commands.end(),
                          [&](const Command& command) { return command.name == name; });
}

ExitCode runParsed(const std::vector<std::string>& arguments, const std::vector<Command>& commands)
{
    CLI::App program("Torrance draws glTF scenes with physically based shading and knows its own error.");
    GlobalOptions global;
    global.arguments = arguments;
    declareProgram(program, global, commands);
    const Command* command = parse(program, arguments, commands);
    if (command == nullptr)
        return ExitCode::success;
    checkGlobalOptions(global);
    setLogLevel(global.quiet ? LogLevel::quiet : global.verbose ? LogLevel::verbose : LogLevel::normal);
    return command->run(global);
}

} // namespace

ExitCode runCommandLine(const std::vector<std::string>& arguments, const std::vector<Command>& commands)
{
    try {
        return runParsed(arguments, commands);
    } catch (const Error& error) {
        logError(error.what());
        return error.exitCode;
    } catch (const std::bad_alloc&) {
        logError("not enough memory; take a smaller scene or a smaller picture");
        return ExitCode::input;
    } catch (const std::exception& error) {
        // A fault of ours: nothing below should let a library's exception through.
        logError("internal error: " + std::string(error.what()) + "; please report it");
        return ExitCode::deviceFailure;
    }
}

} // namespace torrance
