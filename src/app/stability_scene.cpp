#include "app/stability_scene.h"

#include "app/device_option.h"
#include "app/lit_scene.h"
#include "app/picture_options.h"
#include "app/progress_line.h"
#include "core/atomic_write.h"
#include "core/error.h"
#include "core/standard_output.h"
#include "files/json_write.h"
#include "gpu/shader_folder.h"
#include "passes/renderer.h"
#include "study/scene_trials.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace torrance {
namespace {

std::string lineOf(const SceneTrial& trial)
{
    if (!trial.applies)
        return fmt::format("skip  {}: {}\n", trial.name, trial.quantity);
    return fmt::format("{}  {}: {:.3g}, allowed {:.3g} ({})\n", trial.passed() ? "pass" : "FAIL", trial.name,
                       trial.measured, trial.allowed, trial.quantity);
}

Json toJson(const SceneTrial& trial)
{
    return Json::Object{{"name", trial.name},         {"applies", trial.applies}, {"passed", trial.passed()},
                        {"measured", trial.measured}, {"allowed", trial.allowed}, {"quantity", trial.quantity}};
}

} // namespace

bool isWithoutScene(const SceneTrialOptions& options)
{
    return options.scene.files.empty() && options.scene.primitive.empty();
}

void declareSceneTrialOptions(CLI::App& app, SceneTrialOptions& o)
{
    app.add_option("-r,--resolution", o.resolution, "Size of a scene's pictures (default 256x256)")->type_name("WxH");
    declareSceneOptions(app, o.scene);
    declareCameraOptions(app, o.camera);
    declareEnvironmentOptions(app, o.environment);
}

ExitCode runSceneTrialsOf(const SceneTrialOptions& o, const std::string& deviceChoice, const std::string& folder,
                          const GlobalOptions& global)
{
    const std::vector<std::string> inputs = sceneInputs(o.scene);
    if (inputs.size() > 1)
        throw usageError("one scene is looked at at a time, not " + std::to_string(inputs.size()), "name one");
    const std::string& input = inputs.front();
    const ivec2 size = chosenSize({.resolution = o.resolution});
    const Settings settings = {.methods = *brdf::findPreset("standard"),
                               .width = size.x,
                               .height = size.y,
                               .background = BackgroundKind::transparent,
                               // What a trial alters may move a surface from one path to another, whose mips are chosen
                               // by other roundings: one path for all.
                               .path = RenderPath::prepass};
    const std::optional<Environment> environment = loadChosenEnvironment(o.environment, settings.methods);
    Subject subject = {.scene = loadLitScene(o.scene, {}, settings.methods, environment, input).scene, .camera = {}};
    subject.camera =
        chooseCamera(cameraOptionsFor(o.camera, input), subject.scene, static_cast<double>(size.x) / size.y);

    const gpu::Device device = openDevice(deviceChoice, global);
    gpu::ShaderLibrary shaders(gpu::shaderFolder(), cacheFolder(global));
    Renderer renderer(device, shaders, cacheFolder(global));
    const DrawScene draw = [&](const Scene& scene, const Camera& camera) {
        const ShadingPlan plan = makePlan(scene, settings);
        return renderer.render(renderer.upload(scene, plan), camera).color;
    };
    ProgressLine progress(input);
    const std::vector<SceneTrial> trials =
        runSceneTrials(subject, draw, [&](int done, int all) { progress.show(done, all); });
    progress.clear();

    if (!folder.empty())
        writeFile(std::filesystem::path(folder) / "scene.html",
                  htmlText(sceneTrialReport(input, device.description.name, trials)));
    Json::Array results;
    for (const SceneTrial& trial : trials) {
        if (global.json != "-" && !global.quiet)
            writeStandardOutput(lineOf(trial));
        results.push_back(toJson(trial));
    }
    writeJson(global.json, Json::Object{{"scene", input}, {"device", device.description.name}, {"trials", results}});
    return std::ranges::all_of(trials, &SceneTrial::passed) ? ExitCode::success : ExitCode::checkFailed;
}

} // namespace torrance
