// What the window asks of the program around it: the same code that reads and writes for the other commands.
#pragma once

#include "files/image_write.h"
#include "files/scene_file.h"
#include "image/display.h"
#include "passes/renderer.h"
#include "plan/method_table.h"
#include "plan/settings.h"
#include "view/edits.h"
#include "view/saved_scene.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace torrance {

struct ViewerHost
{
    // All may throw Error; the first two are called from other threads.
    // Lit as the command line says, without environment. Throws Cancelled where a stop was asked for.
    std::function<LoadedScene(const std::string& input, const std::stop_token&)> loadScene;
    std::function<std::optional<Environment>(const EnvironmentChoice&)> loadEnvironment;
    std::function<Camera(const Scene&, double aspect)> firstCamera; // of the camera options
    std::function<void(const std::string& file, Picture, const Settings&, const WriteSettings&)> writePicture;

    /// The lamp that a preset brings to scenes without a light; nothing for most.
    std::function<std::optional<Light>(const brdf::Preset&)> lampOf;
    /// Writes what a scene was read from anew, with its materials. Called from another thread.
    std::function<void(const SceneToSave& scene, const std::string& target)> saveScene;

    /// What methods are chosen from. Throws Error.
    std::function<MethodTable(const gpu::DeviceDescription&)> methodTable;

    bool choosesCamera = false;            // by an option, and not to fit the scene
    int firstFileCamera = -1;              // of the file's cameras: where the window begins
    std::vector<std::string> inputs;       // what is opened first
    std::vector<std::string> sceneOptions; // as given, for the command line that draws the same picture
    std::vector<std::string> environments; // names that loadEnvironment knows beside files
    Settings settings;
    WriteSettings write;
    EnvironmentChoice environment;
    ivec2 windowSize = {1280, 800};
    bool choosesSize = false; // else it is as it was left last time
    std::string deviceChoice;
    bool validation = false;
    bool watch = false;                 // scene and shaders are read again when they change
    std::filesystem::path cacheFolder;  // empty: none
    std::filesystem::path configFolder; // of settings that are kept; empty: none are
    std::filesystem::path stateFolder;  // of edits that could not be saved; empty: none are kept
    std::filesystem::path shaderFolder;
    std::string report; // JSON of what the window shows, written when it changes; empty: none
};

} // namespace torrance
