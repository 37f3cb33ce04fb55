#include "app/bench_options.h"

#include "app/device_option.h"
#include "app/lit_scene.h"
#include "core/error.h"
#include "study/soak.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

namespace torrance {
namespace {

constexpr int kMaxFrames = 1000000;
constexpr int kMaxSoak = 1000000;
constexpr double kMaxSeconds = 86400.0;

struct Variation
{
    std::string option; // without dashes
    std::vector<std::string> values;
};

Variation parseVariation(const std::string& text)
{
    const std::size_t equals = text.find('=');
    Variation variation = {.option = text.substr(0, equals), .values = {}};
    variation.option.erase(0, variation.option.find_first_not_of('-'));
    std::istringstream values(equals == std::string::npos ? "" : text.substr(equals + 1));
    for (std::string value; std::getline(values, value, ',');)
        variation.values.push_back(value);
    if (variation.option.empty() || variation.values.empty())
        throw usageError("--vary " + text + ": no option and no values", "write --vary path=forward,prepass");
    return variation;
}

// The command line's own parser says what it thinks of the value.
FrameOptions varied(const FrameOptions& frame, const std::string& option, const std::string& value)
{
    FrameOptions result = frame;
    CLI::App app;
    declareFrameOptions(app, result);
    const std::string argument = "--" + option;
    if (app.get_option_no_throw(argument) == nullptr)
        throw usageError("--vary " + option + ": frames have no such option",
                         "path, samples, resolution and the methods can be varied");
    try {
        app.parse(std::vector<std::string>{argument + "=" + value});
    } catch (const CLI::ParseError& error) {
        throw usageError("--vary " + option + ": " + error.what(), "give values that --" + option + " takes");
    }
    return result;
}

std::string stemOf(const std::string& input)
{
    return std::filesystem::path(input).stem().string();
}

// Short where that tells them apart.
std::vector<std::string> sceneNames(const std::vector<std::string>& inputs)
{
    std::vector<std::string> stems;
    for (const std::string& input : inputs)
        stems.push_back(stemOf(input));
    return std::set<std::string>(stems.begin(), stems.end()).size() == inputs.size() ? stems : inputs;
}

} // namespace

void declareBenchOptions(CLI::App& app, BenchOptions& o)
{
    const char* group = "Measuring";
    declareSceneOptions(app, o.scene);
    app.add_option("--frames", o.frames, "The most frames of each; rounds of --growth (default 9 there)")
        ->group(group)
        ->check(CLI::Range(1, kMaxFrames));
    app.add_option("--seconds", o.seconds,
                   "The most time for each picture (default 20), and for each size of --growth (default 60)")
        ->group(group)
        ->check(CLI::Range(0.0, kMaxSeconds));
    app.add_option("--vary", o.vary,
                   "Measure the values of an option of the frame side by side, such as path=forward,prepass; may be "
                   "given several times")
        ->group(group)
        ->type_name("OPTION=VALUE,...")
        ->expected(1)
        ->take_all();
    app.add_option("--against", o.against, "A file of an earlier --json: exit code 1 where a picture has become slower")
        ->group(group)
        ->type_name("FILE");
    app.add_option("--limit", o.limit, "How many times slower is too slow for --against (default 1.1)")
        ->group(group)
        ->check(CLI::Range(1.0, 1000.0));
    app.add_option("--growth", o.growth,
                   "Instead of scenes, what more of something costs: all, or triangles, lights, texels, pixels, "
                   "instances; exit code 1 where it is more than in proportion")
        ->group(group)
        ->type_name("NAMES");
    app.add_option("--soak", o.soak,
                   "Instead of frames, so many whole renders in this process: exit code 1 where its memory grows")
        ->group(group)
        ->check(CLI::Range(kSoakWarmUp + kSoakWindow + 1, kMaxSoak));
    app.add_option("--csv", o.csv, "Every frame, size or reading as a table")->group(group)->type_name("FILE");
    declareFrameOptions(app, o.frame);
    declareCameraOptions(app, o.camera);
    declareEnvironmentOptions(app, o.environment);
    declareLightOptions(app, o.light);
    declareDeviceOption(app, o.device);
}

void checkBenchOptions(const BenchOptions& o)
{
    const bool growth = !o.growth.empty(), soak = o.soak > 0;
    if (growth && soak)
        throw usageError("--growth and --soak exclude each other", "give one of them");
    if ((growth || soak) && (!o.vary.empty() || !o.against.empty()))
        throw usageError("--vary and --against are for frames of scenes", "leave them out with --growth and --soak");
    if (growth && (!o.scene.files.empty() || !o.scene.primitive.empty()))
        throw usageError("--growth makes its own scenes", "leave out the scene");
    if (o.limit && o.against.empty())
        throw usageError("--limit is for --against, which was not given", "name the file to compare with");
}

BenchBounds boundsOf(const BenchOptions& options, double seconds)
{
    return {.frames = options.frames, .seconds = options.seconds.value_or(seconds)};
}

std::vector<FrameVariant> frameVariants(const BenchOptions& options)
{
    std::vector<FrameVariant> variants = {{.name = "", .frame = options.frame}};
    for (const std::string& text : options.vary) {
        const Variation variation = parseVariation(text);
        std::vector<FrameVariant> next;
        for (const FrameVariant& variant : variants)
            for (const std::string& value : variation.values)
                next.push_back(
                    {.name = variant.name + (variant.name.empty() ? "" : " ") + variation.option + "=" + value,
                     .frame = varied(variant.frame, variation.option, value)});
        variants = std::move(next);
    }
    return variants;
}

std::vector<BenchSource> benchSources(const BenchOptions& options, const std::vector<FrameVariant>& variants,
                                      const std::optional<Environment>& environment)
{
    const std::vector<std::string> inputs = sceneInputs(options.scene);
    const std::vector<std::string> names = sceneNames(inputs);
    std::vector<BenchSource> sources;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        for (const FrameVariant& variant : variants) {
            const Settings settings = frameSettings(variant.frame);
            const double aspect = double(settings.width) / settings.height;
            sources.push_back(
                {.name = names[i] + (variant.name.empty() ? "" : " ") + variant.name,
                 .load =
                     [&options, &environment, settings, input = inputs[i]] {
                         return loadLitScene(options.scene, options.light, settings.methods, environment, input).scene;
                     },
                 .camera =
                     [&options, aspect, input = inputs[i]](const Scene& scene) {
                         return chooseCamera(cameraOptionsFor(options.camera, input), scene, aspect);
                     },
                 .settings = settings});
        }
    return sources;
}

} // namespace torrance
