// What can go wrong with a whole scene: the trials of torrance stability SCENE.
#pragma once

#include "study/scene_changes.h"
#include "study/scene_trial.h"

#include <functional>

namespace torrance {

/// Scene-linear RGBA; no background.
using DrawScene = std::function<Image(const Scene&, const Camera&)>;

/// All trials, in a fixed order. `progress` is called with (done, all).
std::vector<SceneTrial> runSceneTrials(const Subject& subject, const DrawScene& draw,
                                       const std::function<void(int, int)>& progress);

} // namespace torrance
