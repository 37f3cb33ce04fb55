#include "app/scene_input.h"

#include "app/option_value.h"
#include "core/data_folder.h"
#include "core/error.h"
#include "core/log.h"
#include "scene/shape_mesh.h"

#include <CLI/CLI.hpp>
#include <cmath>

namespace torrance {
namespace {

struct NamedMesh
{
    const char* name;
    Primitive (*make)();
};

constexpr NamedMesh kPrimitives[] = {{"sphere", sphereMesh}, {"plane", planeMesh}, {"cube", cubeMesh}};

LoadedScene primitiveScene(const std::string& name)
{
    LoadedScene loaded;
    for (const NamedMesh& mesh : kPrimitives)
        if (mesh.name == name)
            loaded.scene.primitives.push_back(mesh.make());
    loaded.scene.name = name;
    loaded.scene.instances.push_back({});
    loaded.facts = factsOfScene(loaded.scene);
    return loaded;
}

} // namespace

void declareSceneOptions(CLI::App& app, SceneOptions& options)
{
    app.add_option("files", options.files, "Scenes: .gltf, .glb or .obj; 'demo' is the built-in one")
        ->type_name("FILE...");
    std::vector<std::string> names;
    for (const NamedMesh& mesh : kPrimitives)
        names.emplace_back(mesh.name);
    addChoice(app, "--primitive", options.primitive, names, "A shape instead of a file, of half size 1")
        ->group("Scene");
    app.add_option("--scene", options.scene, "Scene of the file, from 0 (default: the file's own)")
        ->group("Scene")
        ->check(CLI::Range(0, 1 << 20));
    app.add_flag("--allow-external", options.allowExternal, "Follow URIs that leave the folder of the file")
        ->group("Scene");
    app.add_option("--light-radius", options.lightRadius,
                   "Radius of every point and spot light in metres, instead of the file's (see --area-light)")
        ->group("Light");
    declareMaterialOptions(app, options.material);
}

std::vector<std::string> sceneInputs(const SceneOptions& options)
{
    if (options.primitive.empty()) {
        if (options.files.empty())
            throw usageError("no scene was named", "give a file, demo, or --primitive");
        return options.files;
    }
    if (!options.files.empty())
        throw usageError("--primitive and " + options.files.front() + " exclude each other", "give one of them");
    if (options.scene >= 0 || options.allowExternal)
        throw usageError("--scene and --allow-external are for files", "leave them out with --primitive");
    return {options.primitive};
}

bool isBuiltInScene(const std::string& input)
{
    return input == "demo";
}

std::string sceneFile(const std::string& input)
{
    return isBuiltInScene(input) ? (dataFolder() / "assets" / "demo" / "demo.gltf").string() : input;
}

LoadOptions loadOptions(const SceneOptions& chosen)
{
    LoadOptions options = {.allowExternal = chosen.allowExternal};
    if (chosen.scene >= 0)
        options.scene = chosen.scene;
    return options;
}

LoadedScene buildChosenScene(const SceneOptions& chosen, const std::string& input, const std::stop_token& stop,
                             const KnownImages& known)
{
    LoadOptions options = loadOptions(chosen);
    options.stop = stop;
    options.known = known;
    LoadedScene loaded =
        chosen.primitive.empty() ? loadScene(sceneFile(input), options) : primitiveScene(chosen.primitive);
    if (!chosen.primitive.empty() || choosesMaterial(chosen.material))
        applyMaterial(chosen.material, loaded);
    return loaded;
}

void giveLightsTheirRadius(const SceneOptions& chosen, Scene& scene)
{
    if (!chosen.lightRadius)
        return;
    if (!(*chosen.lightRadius >= 0.0) || !std::isfinite(*chosen.lightRadius))
        throw usageError("--light-radius must be 0 or more", "give metres, such as 0.1");
    bool found = false;
    for (Light& light : scene.lights)
        if (light.kind != Light::Kind::directional) {
            light.radius = *chosen.lightRadius;
            found = true;
        }
    if (!found)
        throw usageError("--light-radius is for point and spot lights, and the scene has none", "leave it out");
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
