// Lights beside those of the scene, from the command line.
#pragma once

#include "brdf/method.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace torrance {

struct LightOptions
{
    std::vector<std::string> lights; // "KIND:NAME=VALUE,..."
};

/// --light, which may be given several times.
void declareLightOptions(CLI::App& app, LightOptions& options);

/// A light from "constant:direction=0,1,1,distance=2,intensity=30", "directional:direction=..." or
/// "point:position=...". Error (usage) for what is no light.
Light parseLight(const std::string& text);

/// Adds the lights that were asked for; where there are none, here and in the scene, the light that a source system's
/// preset brings.
void addChosenLights(const LightOptions& options, const brdf::Preset& methods, Scene& scene);

/// The light that a source system's preset brings to scenes that have none.
std::optional<Light> presetLamp(const brdf::Preset& methods);

} // namespace torrance
