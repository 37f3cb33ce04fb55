#include "app/window_options.h"

#include "app/device_option.h"
#include "app/method_table_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

namespace torrance {
namespace {

/// Of a scene and its methods, and nothing that the window changes.
constexpr std::array kLasting = {"--primitive", "--scene",     "--allow-external", "--light-radius", "--light",
                                 "--quirk",     "--parameter", "--material",       "--base-color",   "--metallic",
                                 "--roughness", "--maps",      "--view-light"};

} // namespace

void declareWindowOptions(CLI::App& app, WindowOptions& o)
{
    o.app = &app;
    o.frame.picture.resolution = "1280x800";
    declareSceneOptions(app, o.scene);
    declareFrameOptions(app, o.frame);
    declareCurveOptions(app, o.output);
    declareCameraOptions(app, o.camera);
    declareEnvironmentOptions(app, o.environment);
    declareLightOptions(app, o.light);
    declareViewOptions(app, o.view);
    declareMethodTableOption(app, o.methods);
    declareDeviceOption(app, o.device);
    app.add_flag("--watch", o.watch, "Read the scene and the shaders again when they change")->group("Window");
    app.add_flag("--validation", o.validation,
                 "Turn Vulkan's validation layer on; the exit code is 1 where it had something to say")
        ->group("Window");
    app.add_option("--report", o.report, "Write what the window shows as JSON whenever it changes, for scripts")
        ->group("Window")
        ->type_name("FILE");
}

bool choosesSize(const WindowOptions& options)
{
    return options.app->count("--resolution") > 0;
}

std::vector<std::string> lastingArguments(const WindowOptions& options)
{
    std::vector<std::string> arguments;
    for (const CLI::Option* option : options.app->get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || std::ranges::find(kLasting, name) == kLasting.end())
            continue;
        if (option->get_items_expected_max() == 0) {
            arguments.push_back(name);
            continue;
        }
        for (const std::string& value : option->results())
            arguments.push_back(name + "=" + value);
    }
    return arguments;
}

} // namespace torrance
