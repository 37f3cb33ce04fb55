// The part of torrance stability that looks at a scene.
#pragma once

#include "app/camera_options.h"
#include "app/command.h"
#include "app/environment_option.h"
#include "app/scene_input.h"

#include <string>

namespace torrance {

struct SceneTrialOptions
{
    std::string resolution = "256x256";
    SceneOptions scene;
    CameraOptions camera;
    EnvironmentOptions environment;
};

/// No scene is named: methods are looked at.
bool isWithoutScene(const SceneTrialOptions& options);

void declareSceneTrialOptions(CLI::App& app, SceneTrialOptions& options);

/// Draws the trials, writes the report to `folder` (none where it is empty) and says what came of them. checkFailed
/// where one failed.
ExitCode runSceneTrialsOf(const SceneTrialOptions& options, const std::string& device, const std::string& folder,
                          const GlobalOptions& global);

} // namespace torrance
