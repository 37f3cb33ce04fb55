// Small scenes whose materials together need the shaders that most models need: what is drawn once of each is in the
// driver's cache when a model that was never seen before comes.
#pragma once

#include "plan/settings.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace torrance {

struct WarmScene
{
    std::string name; // "attributes, sun: 3"
    Scene scene;      // without environment
    Settings settings;
};

/// The default methods, over an environment, on the two paths that the plan chooses between, with no light and with a
/// sun. Which textures a material has and which of its channels vary is enumerated; samplers, sizes that are no powers
/// of two, alpha modes, vertex colours, lines and points are added to the commonest materials alone. The plan packs and
/// names them as it does those of files, so that nothing here knows a shader's text.
std::vector<WarmScene> warmScenes();

/// Sees all of any of them.
Camera warmCamera();

} // namespace torrance
