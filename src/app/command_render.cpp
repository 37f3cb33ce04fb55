#include "app/command_render.h"

#include "app/camera_options.h"
#include "app/device_option.h"
#include "app/environment_option.h"
#include "app/layer_output.h"
#include "app/method_options.h"
#include "app/option_value.h"
#include "app/output_options.h"
#include "app/phases.h"
#include "app/progress_line.h"
#include "app/scene_input.h"
#include "core/data_folder.h"
#include "core/log.h"
#include "core/standard_output.h"
#include "files/json_write.h"
#include "files/scene_file.h"
#include "image/srgb.h"
#include "passes/renderer.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace torrance {
namespace {

struct Options
{
    std::vector<std::string> inputs;
    std::string resolution = "1024x1024";
    int samples = 1;
    std::string background = "environment";
    bool noBackground = false;
    int scene = -1;
    bool allowExternal = false;
    std::string layers;
    bool explain = false;
    std::string device;
    CameraOptions camera;
    EnvironmentOptions environment;
    MethodOptions methods;
    OutputOptions output;
};

// A whole picture is 16 bytes a pixel in several copies: beyond this no machine that we know of holds it.
constexpr int kMaxSide = 32768;
constexpr int kMaxSamples = 4096;

void declare(CLI::App& app, Options& o)
{
    app.add_option("inputs", o.inputs, "Scenes: .gltf or .glb; 'demo' is the built-in one")
        ->required()
        ->type_name("FILE...");
    declareOutputOptions(app, o.output);
    app.add_option("-r,--resolution", o.resolution, "Size of the picture (default 1024x1024)")
        ->group("Output")
        ->type_name("WxH");
    app.add_option("--samples", o.samples, "Samples per pixel, placed by the reconstruction filter (default 1)")
        ->group("Output")
        ->check(CLI::Range(1, kMaxSamples));
    app.add_option(
           "--aov", o.layers,
           "Surface parameters as layers of an EXR or as files beside the picture: all, or names separated by commas")
        ->group("Output")
        ->type_name("NAMES");
    app.add_option("--background", o.background, "environment (default), #RRGGBB (sRGB) or transparent")
        ->group("Output")
        ->type_name("KIND");
    app.add_flag("--no-background", o.noBackground, "The same as --background transparent")->group("Output");
    app.add_option("--scene", o.scene, "Scene of the file, from 0 (default: the file's own)")
        ->group("Scene")
        ->check(CLI::Range(0, 1 << 20));
    app.add_flag("--allow-external", o.allowExternal, "Follow URIs that leave the folder of the file")->group("Scene");
    app.add_flag("--explain", o.explain, "Print what is computed for the scene, what is left out and why");
    declareCameraOptions(app, o.camera);
    declareEnvironmentOptions(app, o.environment);
    declareMethodOptions(app, o.methods);
    declareDeviceOption(app, o.device);
}

ivec2 parseResolution(const std::string& text)
{
    std::string commas = text;
    std::ranges::replace_if(
        commas, [](char c) { return c == 'x' || c == 'X'; }, ',');
    const std::vector<double> sides = parseNumbers("--resolution", commas, 2, 2);
    for (const double side : sides)
        if (side != std::floor(side) || side < 1 || side > kMaxSide)
            throw usageError("--resolution " + text + ": sides must be whole numbers from 1 to " +
                                 std::to_string(kMaxSide),
                             "1024x1024 is the default");
    return {static_cast<int>(sides[0]), static_cast<int>(sides[1])};
}

int hexDigit(char c)
{
    const std::string_view digits = "0123456789abcdef";
    const std::size_t at = digits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

dvec3 parseColor(const std::string& text)
{
    dvec3 color(0.0);
    bool valid = text.size() == 7 && text[0] == '#';
    for (std::size_t c = 0; valid && c < 3; ++c) {
        const int high = hexDigit(text[1 + 2 * c]), low = hexDigit(text[2 + 2 * c]);
        valid = high >= 0 && low >= 0;
        color[static_cast<int>(c)] = srgbDecode((16 * high + low) / 255.0);
    }
    if (!valid)
        throw usageError("--background " + text + ": not a background",
                         "it takes environment, transparent or a colour such as #336699");
    return color;
}

// A picture that does not fit is refused before it brings the machine down: on a software driver every target is
// ordinary memory. Counted are the targets (colour, sum, depth, layers), one copy for reading back and one for writing.
void checkMemory(const ivec2& size, const Options& o)
{
    const double colorTargets = (o.samples > 1 ? 2.0 : 1.0) + (o.layers.empty() ? 0.0 : double(kLayerTargets));
    const double bytes = double(size.x) * size.y * (16.0 * (colorTargets + 2.0) + 4.0);
    const double available = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
    if (bytes > available)
        throw usageError("--resolution " + o.resolution + " needs " +
                             std::to_string(static_cast<long>(std::ceil(bytes / 0x1p30))) +
                             " GiB, more than this machine has",
                         "choose a smaller picture");
}

Settings settingsOf(const Options& o)
{
    const ivec2 size = parseResolution(o.resolution);
    checkMemory(size, o);
    Settings settings = {.methods = chooseMethods(o.methods),
                         .width = size.x,
                         .height = size.y,
                         .samples = o.samples,
                         .layers = !o.layers.empty()};
    if (o.noBackground && o.background != "environment" && o.background != "transparent")
        throw usageError("--no-background and --background " + o.background + " exclude each other",
                         "give one of them");
    if (o.noBackground || o.background == "transparent")
        settings.background = BackgroundKind::transparent;
    else if (o.background != "environment") {
        settings.background = BackgroundKind::color;
        settings.backgroundColor = parseColor(o.background);
    }
    return settings;
}

// The built-in scene is composed for its own camera, which is taken where nothing else was asked for.
CameraOptions cameraFor(const Options& o, const std::string& input)
{
    CameraOptions camera = o.camera;
    const bool asked = !camera.orbit.empty() || !camera.position.empty() || !camera.target.empty() || camera.up ||
                       camera.verticalFov || camera.margin;
    if (isBuiltInScene(input) && !asked && camera.index < 0)
        camera.index = 0;
    return camera;
}

LoadedScene load(const Options& o, const std::string& input)
{
    LoadOptions options = {.allowExternal = o.allowExternal};
    if (o.scene >= 0)
        options.scene = o.scene;
    LoadedScene loaded = loadScene(sceneFile(input), options);
    for (const std::string& warning : loaded.warnings)
        logWarning(warning);
    return loaded;
}

// What all pictures of one run share.
struct Session
{
    const Options& options;
    Phases phases; // before what is timed
    Settings settings;
    std::optional<Environment> environment;
    gpu::Device device;
    gpu::ShaderLibrary shaders;
    Renderer renderer;

    Session(const Options& o, const GlobalOptions& global)
        : options(o), settings(settingsOf(o)),
          environment(phases.time("environment", [&] { return loadChosenEnvironment(o.environment); })),
          device(phases.time("device", [&] { return openDevice(o.device, global); })),
          shaders(dataFolder() / "shaders", cacheFolder(global)), renderer(device, shaders, cacheFolder(global))
    {
    }
};

Json draw(Session& session, const std::string& input, const std::string& output)
{
    Phases& phases = session.phases;
    LoadedScene loaded = phases.time("load", [&] { return load(session.options, input); });
    Scene& scene = loaded.scene;
    scene.environment = session.environment;
    const double aspect = double(session.settings.width) / session.settings.height;
    const Camera camera = chooseCamera(cameraFor(session.options, input), scene, aspect);
    const ShadingPlan plan = phases.time("plan", [&] { return makePlan(scene, session.settings); });
    if (session.options.explain)
        (output == "-" || session.options.output.pattern == "-") ? logInfo(explain(plan))
                                                                 : writeStandardOutput(explain(plan));
    const DeviceScene deviceScene = phases.time("upload", [&] { return session.renderer.upload(scene, plan); });
    ProgressLine progress(input);
    const Picture picture = phases.time("draw", [&] {
        return session.renderer.render(deviceScene, camera, [&](int done, int all) { progress.show(done, all); });
    });
    progress.clear();
    const auto files = phases.time("write", [&] {
        return writeWithLayers(output, picture, session.options.layers, writeSettings(session.options.output));
    });
    Json::Array written(files.begin(), files.end());
    return Json::Object{{"input", input},
                        {"output", output},
                        {"files", written},
                        {"width", session.settings.width},
                        {"height", session.settings.height},
                        {"samples", session.settings.samples},
                        {"triangles", loaded.facts.triangles},
                        {"warnings", Json::Array(loaded.warnings.begin(), loaded.warnings.end())}};
}

Json phasesAsJson(const Phases& phases)
{
    Json::Object object;
    for (const auto& [name, seconds] : phases.all())
        object.emplace_back(name, seconds);
    return object;
}

void reportPhases(const Phases& phases)
{
    std::string text;
    for (const auto& [name, seconds] : phases.all()) {
        char part[64];
        std::snprintf(part, sizeof part, "%s%s %.0f ms", text.empty() ? "" : ", ", name.c_str(), seconds * 1000.0);
        text += part;
    }
    if (peopleAreWatching() && logLevel() != LogLevel::verbose)
        std::fprintf(stderr, "%s\n", text.c_str());
    logInfo("phases: " + text);
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    const std::vector<std::string> outputs = outputNames(options.output, options.inputs);
    checkLayerNames(options.layers);
    if (global.json == "-" && options.output.pattern == "-")
        throw usageError("--output and --json both name standard output", "give one of them a file");
    Session session(options, global);
    Json::Array pictures;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        pictures.push_back(draw(session, options.inputs[i], outputs[i]));
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
