// The light around a scene, by name or by file.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace torrance {

struct EnvironmentOptions
{
    std::string name = "studio"; // "studio", "sky", "furnace", "none", or a file
    double rotation = 0.0;       // degrees about +Y
    double intensity = 1.0;
};

void declareEnvironmentOptions(CLI::App& app, EnvironmentOptions& options);

/// Warnings of the file are logged. Nothing for "none".
std::optional<Environment> loadChosenEnvironment(const EnvironmentOptions& options);

} // namespace torrance
