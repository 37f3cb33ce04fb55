// A scene as a picture of it is lit: its own lights, those of the command line, and the environment.
#pragma once

#include "app/light_option.h"
#include "app/scene_input.h"

#include <optional>
#include <stop_token>
#include <string>

namespace torrance {

/// One of sceneInputs with the lights that were chosen, each with the radius that was, under `environment`. Errors as
/// of loadChosenScene, addChosenLights and giveLightsTheirRadius; warnings are logged. Throws Cancelled where a stop
/// was asked for (LoadOptions::stop).
LoadedScene loadLitScene(const SceneOptions& options, const LightOptions& light, const brdf::Preset& methods,
                         const std::optional<Environment>& environment, const std::string& input,
                         const std::stop_token& stop = {});

} // namespace torrance
