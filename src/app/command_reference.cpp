#include "app/command_reference.h"

#include "app/camera_options.h"
#include "app/environment_option.h"
#include "app/interruption.h"
#include "app/layer_output.h"
#include "app/lit_scene.h"
#include "app/method_options.h"
#include "app/option_value.h"
#include "app/output_options.h"
#include "app/phases.h"
#include "app/picture_options.h"
#include "app/progress_line.h"
#include "app/scene_input.h"
#include "app/version.h"
#include "brdf/brdf.h"
#include "core/error.h"
#include "core/log.h"
#include "files/json_write.h"
#include "passes/layers.h"
#include "reference/checkpoint.h"
#include "reference/reference_picture.h"
#include "reference/surface_targets.h"
#include "scene/camera_view.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

namespace torrance {
namespace {

struct Options
{
    int directions = 256;
    std::optional<double> targetError;
    std::optional<int> maxDirections;
    int pixelSamples = 1;
    std::string layers;
    std::string choice = "combined";
    std::uint64_t seed = 0;
    std::string yardstick = "model";
    bool transport = false;
    bool resume = false;
    double checkpointSeconds = 30.0;
    SceneOptions scene;
    PictureOptions picture;
    CameraOptions camera;
    EnvironmentOptions environment;
    LightOptions light;
    MethodOptions methods;
    OutputOptions output;
};

constexpr int kMaxDirections = 1 << 24;
constexpr int kMaxPixelSamples = 4096;
constexpr int kDefaultMostDirections = 1 << 16;

void declareSampling(CLI::App& app, Options& o)
{
    const char* group = "Sampling";
    app.add_option("--samples", o.directions,
                   "Directions per surface point into the environment and into each light with a radius, rounded up to "
                   "a multiple of 64 (default 256)")
        ->group(group)
        ->check(CLI::Range(1, kMaxDirections));
    app.add_option(
           "--target-error", o.targetError,
           "Double a pixel's directions until half its 95 % interval is below this share of the pixel and 1 % of "
           "the mean pixel together")
        ->group(group)
        ->type_name("E");
    app.add_option("--max-samples", o.maxDirections, "Where --target-error stops doubling (default 65536)")
        ->group(group)
        ->check(CLI::Range(1, kMaxDirections));
    app.add_option("--pixel-samples", o.pixelSamples,
                   "Places in a pixel, by the reconstruction filter: what --samples is to render (default 1)")
        ->group(group)
        ->check(CLI::Range(1, kMaxPixelSamples));
    app.add_option("--seed", o.seed, "Pictures of different seeds are independent: their difference is their noise")
        ->group(group);
    addChoice(app, "--directions", o.choice, {"combined", "brdf", "light"},
              "Where directions are drawn from: combined (default), or one kind alone, as a check of the other")
        ->group(group);
}

void declareCheckpoints(CLI::App& app, Options& o)
{
    app.add_flag("--resume", o.resume, "Go on with OUT.part, which an interrupted run left; begin where there is none")
        ->group("Sampling");
    app.add_option("--checkpoint", o.checkpointSeconds,
                   "Seconds between writes of OUT.part, which keeps the finished tiles (default 30)")
        ->group("Sampling")
        ->check(CLI::Range(0.0, 86400.0));
}

void declare(CLI::App& app, Options& o)
{
    declareSceneOptions(app, o.scene);
    declareOutputOptions(app, o.output);
    declarePictureOptions(app, o.picture);
    app.add_option(
           "--aov", o.layers,
           "Layers of an EXR, or files beside the picture: all, or names separated by commas out of variance and "
           "directions, which an EXR has in any case, and the surface parameters of render's --aov")
        ->group("Output")
        ->type_name("NAMES");
    addChoice(app, "--yardstick", o.yardstick, {"model", "physics"},
              "model (default): the methods asked for, integrated exactly; physics: full Fresnel, random walks between "
              "facets, an energy-preserving body");
    app.add_flag(
        "--transport", o.transport,
        "Shadows and interreflection, too, by paths: --samples counts paths of each surface that a pixel sees");
    declareSampling(app, o);
    declareCheckpoints(app, o);
    declareCameraOptions(app, o.camera);
    declareEnvironmentOptions(app, o.environment);
    declareLightOptions(app, o.light);
    declareMethodOptions(app, o.methods);
}

int wholeRounds(int directions)
{
    return (directions + kDirectionsPerRound - 1) / kDirectionsPerRound * kDirectionsPerRound;
}

std::optional<dvec4> backgroundOf(const PictureOptions& options)
{
    const Background background = chosenBackground(options);
    if (background.kind == BackgroundKind::environment)
        return std::nullopt;
    return background.kind == BackgroundKind::transparent ? dvec4(0.0) : dvec4(background.color, 1.0);
}

void checkTarget(const Options& o)
{
    if (o.targetError && !(*o.targetError > 0.0 && std::isfinite(*o.targetError)))
        throw usageError("--target-error must be above 0", "0.01 is one per cent");
    if (o.maxDirections && !o.targetError)
        throw usageError("--max-samples is the end of --target-error, which was not given",
                         "give --target-error, or the number with --samples");
    if (o.targetError && o.maxDirections.value_or(kDefaultMostDirections) < o.directions)
        throw usageError("--max-samples is below --samples", "--samples is what every pixel gets at least");
}

// Methods that would be ignored are an error: whoever names them expects something of them.
void checkYardstick(const Options& o)
{
    const MethodOptions& m = o.methods;
    const bool named = m.preset != MethodOptions().preset || !m.model.quirks.empty() || !m.model.parameters.empty() ||
                       std::ranges::any_of(m.overrides, [](const auto& slot) { return !slot.second.empty(); });
    if (o.yardstick == "physics" && named)
        throw usageError("--yardstick physics has its own methods, and takes no preset and no other ones",
                         "leave them out, or use --yardstick model");
}

// The integral of a source over an environment is that of its BRDF; phong adds its ambient part once per light, and a
// whole sphere of lights has no end of them.
void checkIntegrable(const brdf::Preset& methods, const EnvironmentOptions& environment, bool transport)
{
    if (methods.model->id == "phong" && transport)
        throw usageError("--transport: the preset " + std::string(methods.id) +
                             " is no BRDF, so that no light goes on from one surface to another",
                         "leave one of them out");
    if (methods.model->id == "phong" && !environment.name.empty() && environment.name != "none")
        throw usageError("the preset " + std::string(methods.id) +
                             " is no BRDF, so that light from an environment has no integral",
                         "leave it out: --environment none");
}

ReferenceSettings settingsOf(const Options& o)
{
    checkTarget(o);
    checkYardstick(o);
    const ivec2 size = chosenSize(o.picture);
    checkMemory(o.picture, 2 * 8 * sizeof(float)); // colour, variance, directions; once more for writing
    ReferenceSettings settings;
    settings.methods = chooseMethods(o.methods);
    settings.physics = o.yardstick == "physics";
    settings.transport = o.transport;
    brdf::requireWholeBrdf(settings.methods);
    checkIntegrable(settings.methods, o.environment, o.transport);
    settings.width = size.x;
    settings.height = size.y;
    settings.pixelSamples = o.pixelSamples;
    settings.directions = wholeRounds(o.directions);
    settings.targetError = o.targetError;
    settings.maxDirections = wholeRounds(o.maxDirections.value_or(kDefaultMostDirections));
    settings.seed = o.seed;
    settings.background = backgroundOf(o.picture);
    settings.choice = o.choice == "brdf"    ? DirectionChoice::brdf
                      : o.choice == "light" ? DirectionChoice::light
                                            : DirectionChoice::combined;
    return settings;
}

// What rays do not meet is said, for render draws it.
void warnOfWhatIsLeftOut(const Scene& scene, const std::string& input)
{
    std::size_t count = 0;
    for (const Instance& instance : scene.instances)
        count += scene.primitives[static_cast<std::size_t>(instance.primitive)].topology != Topology::triangles;
    if (count > 0)
        logWarning(input + ": " + std::to_string(count) + " primitives of points or lines are left out");
}

std::vector<std::string> knownLayers()
{
    std::vector<std::string> names = layerNames();
    names.insert(names.end(), {"variance", "directions"});
    return names;
}

std::string layersFor(const std::string& output, const Options& o)
{
    if (imageFormatOf(output) != ImageFormat::exr)
        return o.layers;
    return (o.layers.empty() ? "" : o.layers + ",") + "variance,directions";
}

Picture pictureOf(ReferencePicture&& reference, std::vector<Layer>&& surfaces)
{
    Picture picture = {.color = std::move(reference.color), .layers = std::move(surfaces)};
    picture.layers.push_back({"variance", {"R", "G", "B"}, std::move(reference.variance)});
    picture.layers.push_back({"directions", {"V"}, std::move(reference.directions)});
    return picture;
}

/// How precise a picture is: over its pixels, half the 95 % interval against |c|_1.
Json::Object precisionOf(const ReferencePicture& picture)
{
    double widths = 0.0, norms = 0.0, directions = 0.0;
    for (std::size_t i = 0; i < picture.directions.texels.size(); ++i) {
        const float* c = picture.color.texels.data() + 4 * i;
        const float* v = picture.variance.texels.data() + 3 * i;
        directions += static_cast<double>(picture.directions.texels[i]);
        if (picture.directions.texels[i] > 0.0f) {
            widths += halfWidth95(dvec3(v[0], v[1], v[2]));
            norms += static_cast<double>(c[0] + c[1] + c[2]);
        }
    }
    return {{"directions", directions}, {"mean_half_width_95", norms > 0.0 ? widths / norms : 0.0}};
}

struct Session
{
    const Options& options;
    Phases phases;
    ReferenceSettings settings;
    std::optional<Environment> environment;

    explicit Session(const Options& o)
        : options(o), settings(settingsOf(o)),
          environment(
              phases.time("environment", [&] { return loadChosenEnvironment(o.environment, settings.methods); }))
    {
    }
};

/// The file beside a picture that keeps what is finished of it; empty for standard output, which has no place beside
/// it.
std::string checkpointOf(const std::string& output)
{
    return output == "-" ? "" : output + ".part";
}

ReferencePicture beginOrResume(const Session& session, const std::string& checkpoint, const ContentHash& inputs)
{
    const bool exists = !checkpoint.empty() && std::filesystem::exists(checkpoint);
    if (exists && session.options.resume) {
        logInfo("going on with " + checkpoint);
        return readCheckpoint(checkpoint, session.settings, inputs);
    }
    if (exists)
        logWarning(checkpoint + ": left by an interrupted run, and not used without --resume");
    return emptyReference(session.settings.width, session.settings.height);
}

ReferencePicture compute(Session& session, const std::string& input, const Scene& scene, const Camera& camera,
                         const std::string& checkpoint)
{
    using Clock = std::chrono::steady_clock;
    const ContentHash inputs = hashOfInputs(scene, camera, session.settings, versionText());
    ReferencePicture picture = beginOrResume(session, checkpoint, inputs);
    const PixelEstimator estimator(scene, camera, session.settings);
    const Interruption interruption;
    ProgressLine progress(input);
    Clock::time_point written = Clock::now();
    const ReferenceWatch watch = {
        .tileDone =
            [&](const ReferencePicture& part, std::size_t done, std::size_t all) {
                progress.show(static_cast<int>(done), static_cast<int>(all));
                const double seconds = std::chrono::duration<double>(Clock::now() - written).count();
                if (checkpoint.empty() || done == all || seconds < session.options.checkpointSeconds)
                    return;
                writeCheckpoint(checkpoint, part, inputs);
                written = Clock::now();
            },
        .stop = [&] { return interruption.came(); }};
    if (completeReference(estimator, session.settings, picture, watch))
        return picture;
    progress.clear();
    if (!checkpoint.empty()) {
        writeCheckpoint(checkpoint, picture, inputs);
        logError("interrupted: " + checkpoint + " keeps what is finished; repeat the command with --resume");
    }
    interruption.obey();
}

Json draw(Session& session, const std::string& input, const std::string& output)
{
    Phases& phases = session.phases;
    const LoadedScene loaded = phases.time("load", [&] {
        return loadLitScene(session.options.scene, session.options.light, session.settings.methods, session.environment,
                            input);
    });
    const Scene& scene = loaded.scene;
    warnOfWhatIsLeftOut(scene, input);
    const double aspect = double(session.settings.width) / session.settings.height;
    const Camera camera = chooseCamera(cameraOptionsFor(session.options.camera, input), scene, aspect);
    ReferencePicture picture =
        phases.time("integrate", [&] { return compute(session, input, scene, camera, checkpointOf(output)); });
    Json::Object result = precisionOf(picture);
    std::vector<Layer> surfaces;
    if (!session.options.layers.empty())
        surfaces = phases.time("layers", [&] {
            return splitLayers(surfaceTargets(scene, camera, session.settings.width, session.settings.height),
                               cameraPosition(camera));
        });
    const auto files = phases.time("write", [&] {
        return writeWithLayers(output, pictureOf(std::move(picture), std::move(surfaces)),
                               layersFor(output, session.options),
                               writeSettings(session.options.output, session.settings.methods));
    });
    if (const std::string checkpoint = checkpointOf(output); !checkpoint.empty())
        std::filesystem::remove(checkpoint);
    result.emplace_back("input", input);
    result.emplace_back("output", output);
    result.emplace_back("files", Json::Array(files.begin(), files.end()));
    result.emplace_back("width", session.settings.width);
    result.emplace_back("height", session.settings.height);
    return result;
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    const std::vector<std::string> inputs = sceneInputs(options.scene);
    const std::vector<std::string> outputs = outputNames(options.output, inputs);
    if (global.json == "-" && options.output.pattern == "-")
        throw usageError("--output and --json both name standard output", "give one of them a file");
    checkLayerNames(options.layers, knownLayers());
    if (options.output.pattern == "-" && !options.layers.empty())
        throw usageError("--aov: standard output takes one picture", "name a file with --output");
    Session session(options);
    Json::Array pictures;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        pictures.push_back(draw(session, inputs[i], outputs[i]));
        if (outputs[i] != "-")
            logInfo("wrote " + outputs[i]);
    }
    reportPhases(session.phases);
    writeJson(global.json, Json::Object{{"pictures", pictures}, {"seconds", phasesAsJson(session.phases)}});
    return ExitCode::success;
}

} // namespace

Command referenceCommand()
{
    return makeCommand<Options>("reference", "Integrate the shading of scenes on the processor, to a stated confidence",
                                declare, run);
}

} // namespace torrance
