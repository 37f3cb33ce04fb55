#include "app/environment_option.h"

#include "core/data_folder.h"
#include "core/error.h"
#include "core/log.h"
#include "files/environment_file.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>

namespace torrance {
namespace {

constexpr std::array<std::string_view, 3> kBuiltIn = {"studio", "sky", "furnace"};

std::string fileOf(const std::string& name)
{
    if (std::ranges::find(kBuiltIn, name) != kBuiltIn.end())
        return (dataFolder() / "assets" / "environments" / (name + ".hdr")).string();
    return name;
}

} // namespace

std::span<const std::string_view> builtInEnvironments()
{
    return kBuiltIn;
}

std::string environmentName(const EnvironmentOptions& options, const brdf::Preset& methods)
{
    if (!options.name.empty())
        return options.name;
    return brdf::isComposed(methods) ? "studio" : "none"; // sources bring a lamp
}

void declareEnvironmentOptions(CLI::App& app, EnvironmentOptions& options)
{
    app.add_option(
           "-e,--environment,--hdri,--ibl", options.name,
           "Light around the scene: studio (default), sky, furnace, none, or a lat-long picture (.hdr, .exr, ...)")
        ->group("Light")
        ->type_name("NAME|FILE");
    app.add_option("--environment-rotation", options.rotation, "Turns the environment about +Y, degrees")
        ->group("Light");
    app.add_option("--environment-intensity", options.intensity, "Factor on the environment")->group("Light");
}

std::optional<Environment> loadChosenEnvironment(const EnvironmentOptions& options, const brdf::Preset& methods)
{
    const std::string name = environmentName(options, methods);
    if (!std::isfinite(options.rotation))
        throw usageError("--environment-rotation must be a number", "give degrees");
    if (!(options.intensity >= 0.0) || !std::isfinite(options.intensity))
        throw usageError("--environment-intensity must be 0 or more", "1 is the default");
    if (name == "none") {
        if (options.rotation != 0.0 || options.intensity != 1.0)
            throw usageError("without an environment there is nothing to turn or to scale",
                             "leave out --environment-rotation and --environment-intensity");
        return std::nullopt;
    }
    LoadedEnvironment loaded = loadEnvironment(fileOf(name));
    for (const std::string& warning : loaded.warnings)
        logWarning(warning);
    return Environment{.name = name,
                       .radiance = std::move(loaded.radiance),
                       .rotation = options.rotation * kPi / 180.0,
                       .intensity = options.intensity};
}

} // namespace torrance
