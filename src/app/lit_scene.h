// A scene as a picture of it is lit: its own lights, those of the command line, and the environment.
#pragma once

#include "app/light_option.h"
#include "app/scene_input.h"

#include <optional>
#include <stop_token>
#include <string>

namespace torrance {

/// One of sceneInputs with the lights that were chosen, each with the radius that was, under `environment`. Errors as
/// of buildChosenScene, addChosenLights and giveLightsTheirRadius. Throws Cancelled where a stop was asked for
/// (LoadOptions::stop). `known`: LoadOptions::known.
LoadedScene buildLitScene(const SceneOptions& options, const LightOptions& light, const brdf::Preset& methods,
                          const std::optional<Environment>& environment, const std::string& input,
                          const std::stop_token& stop = {}, const KnownImages& known = {});

/// The same; its warnings are logged.
LoadedScene loadLitScene(const SceneOptions& options, const LightOptions& light, const brdf::Preset& methods,
                         const std::optional<Environment>& environment, const std::string& input,
                         const std::stop_token& stop = {}, const KnownImages& known = {});

} // namespace torrance
