#include "app/scene_input.h"

#include "core/data_folder.h"
#include "core/log.h"

#include <CLI/CLI.hpp>

namespace torrance {

void declareSceneOptions(CLI::App& app, SceneOptions& options)
{
    app.add_option("--scene", options.scene, "Scene of the file, from 0 (default: the file's own)")
        ->group("Scene")
        ->check(CLI::Range(0, 1 << 20));
    app.add_flag("--allow-external", options.allowExternal, "Follow URIs that leave the folder of the file")
        ->group("Scene");
}

bool isBuiltInScene(const std::string& input)
{
    return input == "demo";
}

std::string sceneFile(const std::string& input)
{
    return isBuiltInScene(input) ? (dataFolder() / "assets" / "demo" / "demo.gltf").string() : input;
}

LoadedScene loadChosenScene(const SceneOptions& chosen, const std::string& input)
{
    LoadOptions options = {.allowExternal = chosen.allowExternal};
    if (chosen.scene >= 0)
        options.scene = chosen.scene;
    LoadedScene loaded = loadScene(sceneFile(input), options);
    for (const std::string& warning : loaded.warnings)
        logWarning(warning);
    return loaded;
}

CameraOptions cameraOptionsFor(const CameraOptions& options, const std::string& input)
{
    CameraOptions camera = options;
    const bool asked = !camera.orbit.empty() || !camera.position.empty() || !camera.target.empty() || camera.up ||
                       camera.verticalFov || camera.margin;
    if (isBuiltInScene(input) && !asked && camera.index < 0)
        camera.index = 0;
    return camera;
}

} // namespace torrance
