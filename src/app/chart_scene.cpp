#include "app/chart_scene.h"

#include "app/chart_output.h"
#include "app/device_option.h"
#include "app/interruption.h"
#include "app/lit_scene.h"
#include "app/method_table_option.h"
#include "app/picture_options.h"
#include "app/progress_line.h"
#include "app/today.h"
#include "app/tolerance_option.h"
#include "app/version.h"
#include "core/atomic_write.h"
#include "core/error.h"
#include "core/log.h"
#include "core/read_file.h"
#include "gpu/shader_folder.h"
#include "math/norm.h"
#include "math/replicates.h"
#include "reference/checkpoint.h"
#include "reference/reference_settings.h"
#include "study/bench_record.h"
#include "study/chart_plans.h"
#include "study/tolerance_variant.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace torrance {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPartSchema = "torrance-plans-part/1";
constexpr std::string_view kSchema = "torrance-plans/1";
constexpr int kMostDirections = 1 << 16;

/// Ends the work at a checkpoint.
struct Interrupted
{
};

Json resultsAsJson(const std::vector<PlanResult>& results)
{
    Json::Array array;
    for (const PlanResult& result : results)
        array.push_back(asJson(result));
    return array;
}

std::string partText(const std::vector<PlanResult>& results, const std::string& inputs)
{
    return jsonText(
        Json::Object{{"schema", std::string(kPartSchema)}, {"inputs", inputs}, {"plans", resultsAsJson(results)}});
}

std::vector<PlanResult> begun(const std::string& part, bool resume, const std::string& inputs)
{
    if (!fs::exists(part))
        return {};
    if (!resume) {
        logWarning(part + ": left by an interrupted run, and not used without --resume");
        return {};
    }
    logInfo("going on with " + part);
    const std::vector<std::byte> bytes = readFile(part);
    const Json json = parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, part);
    const JsonView view(json, part);
    if (view.member("schema").text() != kPartSchema || view.member("inputs").text() != inputs)
        throw inputError(part, "", "was left by another chart: other options, scene, device or program",
                         "remove it, or repeat the command that was interrupted");
    std::vector<PlanResult> results;
    for (const JsonView& plan : view.member("plans").elements())
        results.push_back(planResultFrom(plan));
    return results;
}

Settings baseSettings(const std::string& resolution)
{
    const ivec2 size = chosenSize({.resolution = resolution.empty() ? kChartResolution : resolution});
    Settings settings;
    settings.methods = *brdf::findPreset("standard");
    settings.width = size.x;
    settings.height = size.y;
    settings.background = BackgroundKind::transparent;
    return settings;
}

Picture layersOf(const TrialDevice& on, const Scene& scene, const Camera& camera, Settings settings)
{
    settings.layers = true;
    // So that what other filters change is their error.
    settings.methods.textureFilter = brdf::findMethod(brdf::Slot::textureFilter, "trilinear_exact");
    const ShadingPlan plan = makePlan(scene, settings);
    Renderer renderer(on.device, on.shaders, on.cacheFolder);
    const DeviceScene uploaded = renderer.upload(scene, plan);
    return renderer.render(uploaded, camera);
}

// Half the 95 % interval of the truth, over its light.
double noiseOf(const SurfaceTruth& truth)
{
    double widths = 0.0, norms = 0.0;
    for (const Replicates& light : truth.light) { // 0 where nothing counts
        widths += halfWidth95(light.variance());
        norms += norm1(light.mean());
    }
    return norms > 0.0 ? widths / norms : 0.0;
}

std::vector<Tolerance> tolerancesOf(const std::string& list)
{
    std::vector<Tolerance> tolerances;
    if (list == "none")
        return tolerances;
    std::istringstream stream(list);
    for (std::string text; std::getline(stream, text, ',');) {
        if (text.empty())
            throw usageError("--tolerance " + list + ": one of the list is empty", "write draft,1% or none");
        tolerances.push_back({.mean = parseTolerance(text), .percentile99 = {}});
    }
    return tolerances;
}

bool isOf(const Tolerance& tolerance, const PlanResult& result)
{
    return result.kind == kToleranceKind && result.name.starts_with(toleranceName(tolerance));
}

void requireSomethingCovered(const SurfaceTruth& truth, const std::string& input)
{
    if (std::ranges::find(truth.counted, true) == truth.counted.end())
        throw inputError(input, "", "covers no pixel of the picture with a surface that is not blended",
                         "choose another camera");
}

} // namespace

void declareSceneChartOptions(CLI::App& app, SceneChartOptions& o)
{
    declareSceneOptions(app, o.scene);
    app.add_option("-r,--resolution", o.resolution, "Of a scene's pictures (default 384x384)")->type_name("WxH");
    app.add_option("--directions", o.directions,
                   "Of a scene's exact light, for each surface and light, rounded up to a multiple of 64 (default 256)")
        ->check(CLI::Range(1, kMostDirections));
    app.add_option("--tolerance", o.tolerances,
                   "Of a scene: the plans that these choose are charted, too; shares or names as of render, separated "
                   "by commas, or none (default standard)")
        ->type_name("E,...");
    declareCameraOptions(app, o.camera);
    declareLightOptions(app, o.light);
}

void chartScene(const SceneChartOptions& o, const MeasuringOptions& measuring, const GlobalOptions& global,
                const fs::path& folder)
{
    const std::vector<std::string> inputs = sceneInputs(o.scene);
    if (inputs.size() != 1)
        throw usageError("a chart is of one scene, and " + std::to_string(inputs.size()) + " were given",
                         "chart them one after the other");
    const Settings settings = baseSettings(o.resolution);
    const std::vector<Tolerance> tolerances = tolerancesOf(o.tolerances);
    const std::optional<Environment> environment = loadChosenEnvironment(measuring.environment, settings.methods);
    const Scene scene = loadLitScene(o.scene, o.light, settings.methods, environment, inputs.front()).scene;
    const Camera camera =
        chooseCamera(cameraOptionsFor(o.camera, inputs.front()), scene, double(settings.width) / settings.height);
    const gpu::Device device = openDevice(measuring.device, global);
    gpu::ShaderLibrary shaders(gpu::shaderFolder(), cacheFolder(global));
    const TrialDevice on = {device, shaders, cacheFolder(global)};
    const BenchMachine machine = thisMachine(device.description);

    ReferenceSettings reference;
    reference.methods = settings.methods;
    reference.width = settings.width;
    reference.height = settings.height;
    reference.directions = (o.directions + kDirectionsPerRound - 1) / kDirectionsPerRound * kDirectionsPerRound;
    const std::string hash = hashOfInputs(scene, camera, reference,
                                          versionText() + machine.processor + machine.device + machine.driver +
                                              fmt::format("{} {}", measuring.seconds, o.tolerances))
                                 .hex();
    const std::string part = (folder / "plans.part").string();
    std::vector<PlanResult> results = begun(part, measuring.resume, hash);
    writeFile(part, partText(results, hash)); // what cannot be written is said before minutes are spent

    const Interruption interruption;
    std::vector<PlanVariant> variants = planVariants(scene, settings);
    const MethodTable table = loadMethodTable("shipped", device.description, true).table;
    ProgressLine progress("plans");
    const auto checkpoint = [&] {
        if (interruption.came())
            throw Interrupted{};
    };
    SurfaceTruth truth;
    try {
        truth = surfaceTruth(scene, camera, settings.methods, layersOf(on, scene, camera, settings),
                             reference.directions, [&] { return interruption.came(); });
        checkpoint();
        requireSomethingCovered(truth, inputs.front());
        for (const Tolerance& tolerance : tolerances)
            if (std::ranges::none_of(results, [&](const PlanResult& r) { return isOf(tolerance, r); }))
                variants.push_back(toleranceVariant(on, scene, camera, settings, table, tolerance, checkpoint));
        for (const PlanVariant& variant : variants) {
            if (std::ranges::find(results, variant.name, &PlanResult::name) == results.end()) {
                results.push_back(measurePlan(on, scene, camera, variants.front(), variant, truth,
                                              {.frames = 0, .seconds = measuring.seconds}, checkpoint));
                writeFile(part, partText(results, hash));
            }
            progress.show(static_cast<int>(&variant - variants.data()) + 1, static_cast<int>(variants.size()));
        }
    } catch (const Interrupted&) {
        progress.clear();
        logError("interrupted: " + part + " keeps what is finished; repeat the command with --resume");
        interruption.obey();
    }
    progress.clear();
    const std::string name = fs::path(inputs.front()).stem().string();
    const std::string about = fmt::format(
        "{}, {}; {}, {} cores; environment {}; {}x{}; {}; {}. The exact light's own 95 % interval is {:.2g} % wide on "
        "either side.",
        machine.device, machine.driver, machine.processor, machine.cores, environment ? environment->name : "none",
        settings.width, settings.height, today(), versionText(), 100.0 * noiseOf(truth));
    writeChart(folder, "plans", plansPage(name, about, results, tolerances));
    writeFile(folder / "plans.csv", plansCsv(results));
    writeFile(folder / "plans.json", jsonText(Json::Object{{"schema", std::string(kSchema)},
                                                           {"program", versionText()},
                                                           {"date", today()},
                                                           {"device", machine.device},
                                                           {"driver", machine.driver},
                                                           {"processor", machine.processor},
                                                           {"scene", name},
                                                           {"width", settings.width},
                                                           {"height", settings.height},
                                                           {"truth_noise", noiseOf(truth)},
                                                           {"plans", resultsAsJson(results)}}));
    fs::remove(part);
}

} // namespace torrance
