// The light around a scene, by name or by file.
#pragma once

#include "brdf/method.h"
#include "scene/scene.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace torrance {

struct EnvironmentOptions
{
    std::string name;      // "studio", "sky", "furnace", "none", or a file; empty: as the preset has it
    double rotation = 0.0; // degrees about +Y
    double intensity = 1.0;
};

void declareEnvironmentOptions(CLI::App& app, EnvironmentOptions& options);

/// "studio", "sky" and "furnace": those that are named and not read from a file of the user's.
std::span<const std::string_view> builtInEnvironments();

/// The name that was given, or where none was: "studio", or "none" for a preset that defines no light from an
/// environment.
std::string environmentName(const EnvironmentOptions& options, const brdf::Preset& methods);

/// Warnings of the file are logged. Nothing for "none". Of environmentName.
std::optional<Environment> loadChosenEnvironment(const EnvironmentOptions& options, const brdf::Preset& methods);

} // namespace torrance
