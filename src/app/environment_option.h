// The light around a scene, by name or by file.
#pragma once

#include "brdf/method.h"
#include "scene/scene.h"

#include <optional>
#include <string>

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

/// Warnings of the file are logged. Nothing for "none". Where none is named: the studio, or nothing for a preset that
/// defines no light from an environment.
std::optional<Environment> loadChosenEnvironment(const EnvironmentOptions& options, const brdf::Preset& methods);

} // namespace torrance
