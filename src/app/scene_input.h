// Scenes as they are named on the command line.
#pragma once

#include "app/camera_options.h"
#include "files/scene_file.h"

#include <string>

namespace CLI {
class App;
}

namespace torrance {

struct SceneOptions
{
    int scene = -1; // of the file, -1 = the file's own choice
    bool allowExternal = false;
};

void declareSceneOptions(CLI::App& app, SceneOptions& options);

/// `demo`, which comes with a camera of its own.
bool isBuiltInScene(const std::string& input);

/// The file of an input: `demo` is the built-in scene, anything else a path.
std::string sceneFile(const std::string& input);

/// Warnings of the file are logged.
LoadedScene loadChosenScene(const SceneOptions& options, const std::string& input);

/// The camera options for an input: the built-in scene is composed for its own camera, which is taken where nothing
/// else was asked for.
CameraOptions cameraOptionsFor(const CameraOptions& options, const std::string& input);

} // namespace torrance
