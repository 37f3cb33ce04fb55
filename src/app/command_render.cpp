#include "app/command_render.h"

#include "app/camera_options.h"
#include "app/device_option.h"
#include "app/environment_option.h"
#include "app/layer_output.h"
#include "app/lit_scene.h"
#include "app/method_options.h"
#include "app/option_value.h"
#include "app/output_options.h"
#include "app/phases.h"
#include "app/picture_options.h"
#include "app/progress_line.h"
#include "app/scene_input.h"
#include "app/view_option.h"
#include "brdf/environment.h"
#include "core/data_folder.h"
#include "core/log.h"
#include "core/standard_output.h"
#include "files/json_write.h"
#include "passes/renderer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace torrance {
namespace {

struct Options
{
    int samples = 1;
    std::string path = "forward";
    std::optional<int> environmentSamples;
    std::optional<int> lightSamples;
    std::string layers;
    bool explain = false;
    std::string device;
    SceneOptions scene;
    PictureOptions picture;
    CameraOptions camera;
    EnvironmentOptions environment;
    LightOptions light;
    ViewOptions view;
    MethodOptions methods;
    OutputOptions output;
};

constexpr int kMaxSamples = 4096;
constexpr int kMaxDirections = 65536; // seconds per picture of a thumbnail

void declare(CLI::App& app, Options& o)
{
    declareSceneOptions(app, o.scene);
    declareOutputOptions(app, o.output);
    declarePictureOptions(app, o.picture);
    app.add_option("--samples", o.samples, "Samples per pixel, placed by the reconstruction filter (default 1)")
        ->group("Output")
        ->check(CLI::Range(1, kMaxSamples));
    app.add_option(
           "--aov", o.layers,
           "Surface parameters as layers of an EXR or as files beside the picture: all, or names separated by commas")
        ->group("Output")
        ->type_name("NAMES");
    addChoice(app, "--path", o.path, {"forward", "prepass", "attributes", "deferred"},
              "Shade surfaces as they are drawn, draw depth first, shade each pixel once from what was interpolated, or "
              "from a G-buffer of floats")
        ->group("Methods");
    app.add_flag("--explain", o.explain, "Print what is computed for the scene, what is left out and why");
    declareCameraOptions(app, o.camera);
    declareEnvironmentOptions(app, o.environment);
    declareLightOptions(app, o.light);
    declareViewOptions(app, o.view);
    declareMethodOptions(app, o.methods);
    app.add_option(
           "--environment-samples", o.environmentSamples,
           "Directions per pixel and picture of the environment_specular methods that draw samples (default 64)")
        ->group("Methods")
        ->check(CLI::Range(1, kMaxDirections));
    app.add_option("--light-samples", o.lightSamples,
                   "Directions per pixel, picture and light of --area-light sampled (default 64)")
        ->group("Methods")
        ->check(CLI::Range(1, kMaxDirections));
    declareDeviceOption(app, o.device);
}

// Counted are the targets (colour, sum, depth, layers, G-buffer), each ordinary memory on a software driver, one copy
// for reading back and one for writing.
double bytesPerPixel(const Options& o)
{
    const double colorTargets = (o.samples > 1 ? 2.0 : 1.0) + (o.layers.empty() ? 0.0 : double(kLayerTargets)) +
                                (o.path == "deferred" ? double(kGBufferTargets) : 0.0);
    return 16.0 * (colorTargets + 2.0) + 4.0;
}

RenderPath pathOf(const std::string& name)
{
    return name == "prepass"      ? RenderPath::prepass
           : name == "attributes" ? RenderPath::attributes
           : name == "deferred"   ? RenderPath::deferred
                                  : RenderPath::forward;
}

Settings settingsOf(const Options& o)
{
    const ivec2 size = chosenSize(o.picture);
    checkMemory(o.picture, bytesPerPixel(o));
    const Background background = chosenBackground(o.picture);
    const brdf::Preset methods = chooseMethods(o.methods);
    if (o.environmentSamples && !(methods.environmentSpecular && brdf::drawsSamples(*methods.environmentSpecular)))
        throw usageError("--environment-samples is for methods that draw samples, and the environment's is " +
                             std::string(methods.environmentSpecular ? methods.environmentSpecular->id : "none"),
                         "choose one with --environment-specular, such as vndf_bounded");
    if (o.lightSamples && methods.areaLight->id != "sampled")
        throw usageError("--light-samples is for --area-light sampled, and the method is " +
                             std::string(methods.areaLight->id),
                         "choose it, or leave the number out");
    Settings settings = {.methods = methods,
                         .width = size.x,
                         .height = size.y,
                         .samples = o.samples,
                         .environmentSamples = o.environmentSamples.value_or(Settings().environmentSamples),
                         .lightSamples = o.lightSamples.value_or(Settings().lightSamples),
                         .background = background.kind,
                         .backgroundColor = background.color,
                         .path = pathOf(o.path),
                         .layers = !o.layers.empty()};
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
    gpu::Device device;
    gpu::ShaderLibrary shaders;
    Renderer renderer;

    Session(const Options& o, const GlobalOptions& global)
        : options(o), resultOnStandardOutput(o.output.pattern == "-" || global.json == "-"), settings(settingsOf(o)),
          environment(
              phases.time("environment", [&] { return loadChosenEnvironment(o.environment, settings.methods); })),
          device(phases.time("device", [&] { return openDevice(o.device, global); })),
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
    const LoadedScene loaded = phases.time("load", [&] {
        return loadLitScene(session.options.scene, session.options.light, session.settings.methods, session.environment,
                            input);
    });
    const Scene& scene = loaded.scene;
    const double aspect = double(session.settings.width) / session.settings.height;
    const Camera camera = chooseCamera(cameraOptionsFor(session.options.camera, input), scene, aspect);
    const ShadingPlan plan = phases.time("plan", [&] { return makePlan(scene, session.settings); });
    if (session.options.explain)
        sayBeside(session, explain(plan));
    const DeviceScene deviceScene = phases.time("upload", [&] { return session.renderer.upload(scene, plan); });
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
    Session session(options, global);
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
