#include "app/render_options.h"

#include "app/device_option.h"
#include "core/error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <filesystem>

namespace torrance {
namespace {

/// Options that say where a picture goes or what is told of it, not what it shows.
constexpr std::array kNotOfThePicture = {"--output", "--tone",    "--transfer", "--exposure", "--bits",  "--quality",
                                         "--aov",    "--explain", "--certify",  "--device",   "--quiet", "--verbose",
                                         "--json",   "--help",    "--version",  "--no-cache"};

bool isBuiltInEnvironment(const std::string& name)
{
    return name.empty() || name == "none" || std::ranges::count(builtInEnvironments(), name) > 0;
}

std::string seenFrom(const std::string& folder, const std::string& path)
{
    if (std::filesystem::path(path).is_absolute())
        return path;
    return std::filesystem::absolute(path)
        .lexically_normal()
        .lexically_relative(std::filesystem::absolute(folder).lexically_normal())
        .string();
}

std::string foundIn(const std::string& folder, const std::string& path)
{
    return std::filesystem::path(path).is_absolute() ? path : (std::filesystem::path(folder) / path).string();
}

std::string recordedValue(const std::string& option, const std::string& value, const std::string& folder)
{
    const bool isPath = (option == "--environment" && !isBuiltInEnvironment(value)) || option == "--maps";
    return isPath ? seenFrom(folder, value) : value;
}

} // namespace

void declareRenderOptions(CLI::App& app, RenderOptions& o)
{
    o.app = &app;
    declareSceneOptions(app, o.scene);
    declareOutputOptions(app, o.output);
    declareFrameOptions(app, o.frame);
    app.add_option(
           "--aov", o.layers,
           "Surface parameters as layers of an EXR or as files beside the picture: all, or names separated by commas")
        ->group("Output")
        ->type_name("NAMES");
    app.add_flag("--explain", o.explain, "Print what is computed for the scene, what is left out and why");
    declareCertifyOption(app, o.certify);
    declareToleranceOption(app, o.tolerance);
    declareCameraOptions(app, o.camera);
    declareEnvironmentOptions(app, o.environment);
    declareLightOptions(app, o.light);
    declareViewOptions(app, o.view);
    declareDeviceOption(app, o.device);
}

Settings renderSettings(const RenderOptions& o)
{
    Settings settings = frameSettings(o.frame, !o.layers.empty());
    chooseView(o.view, o.output, settings);
    return settings;
}

std::vector<std::string> recordedArguments(const RenderOptions& options, const std::string& input,
                                           const std::string& folder)
{
    std::vector<std::string> arguments;
    if (options.scene.primitive.empty())
        arguments.push_back(isBuiltInScene(input) ? input : seenFrom(folder, input));
    for (const CLI::Option* option : options.app->get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || option->get_positional() ||
            std::ranges::find(kNotOfThePicture, name) != kNotOfThePicture.end())
            continue;
        if (option->get_items_expected_max() == 0) {
            arguments.push_back(name);
            continue;
        }
        for (const std::string& value : option->results())
            arguments.push_back(name + "=" + recordedValue(name, value, folder));
    }
    return arguments;
}

RenderOptions optionsOfRecord(const std::vector<std::string>& arguments, const std::string& folder,
                              const std::string& file)
{
    RenderOptions options;
    CLI::App app;
    declareRenderOptions(app, options);
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend()); // CLI11 takes them from the back
    for (std::string& argument : reversed)
        if (argument.empty() || argument == "-h" || argument == "--help")
            throw inputError(file, "/scene/arguments", "holds what is no recorded option", "certify the picture again");
    reversed.insert(reversed.begin(), "--output=picture.exr"); // which the record does not need, and the options do
    try {
        app.parse(std::move(reversed));
    } catch (const CLI::ParseError& error) {
        throw inputError(file, "/scene/arguments", error.what(), "certify the picture again with this build");
    }
    options.app = nullptr;
    for (std::string& scene : options.scene.files)
        if (!isBuiltInScene(scene))
            scene = foundIn(folder, scene);
    if (!isBuiltInEnvironment(options.environment.name))
        options.environment.name = foundIn(folder, options.environment.name);
    if (!options.scene.material.maps.empty())
        options.scene.material.maps = foundIn(folder, options.scene.material.maps);
    return options;
}

} // namespace torrance
