#include "app/command_render.h"

#include "app/camera_options.h"
#include "app/device_option.h"
#include "app/environment_option.h"
#include "app/frame_options.h"
#include "app/layer_output.h"
#include "app/lit_scene.h"
#include "app/output_options.h"
#include "app/phases.h"
#include "app/progress_line.h"
#include "app/scene_input.h"
#include "app/view_option.h"
#include "core/data_folder.h"
#include "core/log.h"
#include "core/standard_output.h"
#include "files/json_write.h"
#include "passes/renderer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <future>

namespace torrance {
namespace {

struct Options
{
    std::string layers;
    bool explain = false;
    std::string device;
    SceneOptions scene;
    FrameOptions frame;
    CameraOptions camera;
    EnvironmentOptions environment;
    LightOptions light;
    ViewOptions view;
    OutputOptions output;
};

void declare(CLI::App& app, Options& o)
{
    declareSceneOptions(app, o.scene);
    declareOutputOptions(app, o.output);
    declareFrameOptions(app, o.frame);
    app.add_option(
           "--aov", o.layers,
           "Surface parameters as layers of an EXR or as files beside the picture: all, or names separated by commas")
        ->group("Output")
        ->type_name("NAMES");
    app.add_flag("--explain", o.explain, "Print what is computed for the scene, what is left out and why");
    declareCameraOptions(app, o.camera);
    declareEnvironmentOptions(app, o.environment);
    declareLightOptions(app, o.light);
    declareViewOptions(app, o.view);
    declareDeviceOption(app, o.device);
}

Settings settingsOf(const Options& o)
{
    Settings settings = frameSettings(o.frame, !o.layers.empty());
    chooseView(o.view, o.output, settings);
    return settings;
}

// What all pictures of one run share.
struct Session
{
    const Options& options;
    bool resultOnStandardOutput; // picture or JSON: nothing else may go there
    Phases phases;               // before what is timed
    Settings settings;
    std::optional<Environment> environment;
    std::optional<LoadedScene> first; // of the first input, loaded while the device is opened
    gpu::Device device;
    gpu::ShaderLibrary shaders;
    Renderer renderer;

    Session(const Options& o, const GlobalOptions& global, const std::string& firstInput)
        : Session(o, global, firstInput, settingsOf(o), startOpeningDevice(o.device, global))
    {
    }

    LoadedScene load(const std::string& input)
    {
        return phases.time(
            "load", [&] { return loadLitScene(options.scene, options.light, settings.methods, environment, input); });
    }

private:
    Session(const Options& o, const GlobalOptions& global, const std::string& firstInput, Settings s,
            std::future<gpu::Device> opening)
        : options(o), resultOnStandardOutput(o.output.pattern == "-" || global.json == "-"), settings(std::move(s)),
          environment(
              phases.time("environment", [&] { return loadChosenEnvironment(o.environment, settings.methods); })),
          first(load(firstInput)),
          device(phases.time("device", [&] { return finishOpeningDevice(std::move(opening)); })),
          shaders(dataFolder() / "shaders", cacheFolder(global)), renderer(device, shaders, cacheFolder(global))
    {
    }
};

// To standard output, unless a result goes there.
void sayBeside(const Session& session, const std::string& text)
{
    session.resultOnStandardOutput ? logInfo(text) : writeStandardOutput(text);
}

Json draw(Session& session, const std::string& input, const std::string& output)
{
    Phases& phases = session.phases;
    LoadedScene loaded = session.first ? std::move(*session.first) : session.load(input);
    session.first.reset();
    const Scene& scene = loaded.scene;
    const double aspect = double(session.settings.width) / session.settings.height;
    const Camera camera = chooseCamera(cameraOptionsFor(session.options.camera, input), scene, aspect);
    const ShadingPlan plan = phases.time("plan", [&] { return makePlan(scene, session.settings); });
    if (session.options.explain)
        sayBeside(session, explain(plan));
    const DeviceScene deviceScene =
        phases.time("upload", [&] { return session.renderer.upload(scene, plan, &camera); });
    for (TextureImage& image : loaded.scene.images)
        std::vector<std::byte>().swap(image.texels); // the device has them
    ProgressLine progress(input);
    Picture picture = phases.time("draw", [&] {
        return session.renderer.render(deviceScene, camera, [&](int done, int all) { progress.show(done, all); });
    });
    progress.clear();
    WriteSettings write = writeSettings(session.options.output, session.settings.methods);
    ViewScale viewScale;
    if (const View* view = session.settings.view) {
        ShownView shown = showView(*view, picture.color, isSceneLinear(imageFormatOf(output)));
        picture.color = std::move(shown.picture);
        viewScale = shown.scale;
        write.tone = findToneCurve("none");
        sayBeside(session, fmt::format("{}: {} * {} + {}\n", output, viewScale.factor, view->id, viewScale.offset));
    }
    const auto files =
        phases.time("write", [&] { return writeWithLayers(output, picture, session.options.layers, write); });
    Json::Array written(files.begin(), files.end());
    Json::Object result = {{"input", input},
                           {"output", output},
                           {"files", written},
                           {"width", session.settings.width},
                           {"height", session.settings.height},
                           {"samples", session.settings.samples},
                           {"triangles", loaded.facts.triangles},
                           {"warnings", Json::Array(loaded.warnings.begin(), loaded.warnings.end())}};
    if (session.settings.view)
        result.emplace_back("view", viewAsJson(session.settings, viewScale));
    return result;
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    const std::vector<std::string> inputs = sceneInputs(options.scene);
    const std::vector<std::string> outputs = outputNames(options.output, inputs);
    checkLayerNames(options.layers, layerNames());
    if (global.json == "-" && options.output.pattern == "-")
        throw usageError("--output and --json both name standard output", "give one of them a file");
    Session session(options, global, inputs.front());
    Json::Array pictures;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        pictures.push_back(draw(session, inputs[i], outputs[i]));
        if (outputs[i] != "-")
            logInfo("wrote " + outputs[i]);
    }
    reportPhases(session.phases);
    writeJson(global.json, Json::Object{{"pictures", pictures},
                                        {"device", session.device.description.name},
                                        {"driver", session.device.description.driverVersion},
                                        {"pipelines", session.renderer.pipelineCount()},
                                        {"shaders_compiled", session.shaders.compiledCount()},
                                        {"seconds", phasesAsJson(session.phases)}});
    return ExitCode::success;
}

} // namespace

Command renderCommand()
{
    return makeCommand<Options>("render", "Draw scenes to pictures", declare, run);
}

} // namespace torrance
