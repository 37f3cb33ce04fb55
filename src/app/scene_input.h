// Scenes as they are named on the command line.
#pragma once

#include "app/camera_options.h"
#include "app/material_options.h"
#include "files/scene_file.h"

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace torrance {

struct SceneOptions
{
    std::vector<std::string> files;
    std::string primitive; // instead of files; empty = none
    MaterialOptions material;
    int scene = -1; // of the file, -1 = the file's own choice
    bool allowExternal = false;
    std::optional<double> lightRadius; // metres, of every point and spot light
};

/// The scenes themselves, --primitive, --scene, --allow-external, --light-radius and the options of the
/// material.
void declareSceneOptions(CLI::App& app, SceneOptions& options);

/// What is drawn, by name: the files, or the primitive. Errors (usage): neither or both, an option that would have no
/// effect.
std::vector<std::string> sceneInputs(const SceneOptions& options);

/// `demo`, which comes with a camera of its own.
bool isBuiltInScene(const std::string& input);

/// The file of an input: `demo` is the built-in scene, anything else a path.
std::string sceneFile(const std::string& input);

/// Of a file.
LoadOptions loadOptions(const SceneOptions& options);

/// One of sceneInputs, with the material that was chosen. Throws Cancelled where a stop was asked for
/// (LoadOptions::stop). `known`: LoadOptions::known.
LoadedScene buildChosenScene(const SceneOptions& options, const std::string& input, const std::stop_token& stop = {},
                             const KnownImages& known = {});

/// --light-radius, of the file's lights and of those that other options have added by then. Error (usage) where there
/// is none to have a radius.
void giveLightsTheirRadius(const SceneOptions& options, Scene& scene);

/// The camera options for an input: the built-in scene is composed for its own camera, which is taken where nothing
/// else was asked for.
CameraOptions cameraOptionsFor(const CameraOptions& options, const std::string& input);

} // namespace torrance
