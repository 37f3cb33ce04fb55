#include "study/chart_plans.h"

#include "core/error.h"
#include "files/csv_read.h"
#include "files/image_encoders.h"
#include "image/display.h"
#include "math/replicates.h"
#include "measure/image_metrics.h"
#include "measure/pareto.h"
#include "plan/pixel_sampling_plan.h"
#include "study/base64.h"
#include "study/error_picture.h"
#include "study/slot_trial.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

using brdf::Slot;

constexpr const char* kStandard = "standard";

// Means of blocks of texels along both sides.
Image reduced(const Image& image, int factor)
{
    Image small(std::max(image.width / factor, 1), std::max(image.height / factor, 1), image.channels);
    const int across = std::min(factor, image.width), down = std::min(factor, image.height);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            for (int c = 0; c < image.channels; ++c) {
                double sum = 0.0;
                for (int j = 0; j < down; ++j)
                    for (int i = 0; i < across; ++i)
                        sum += double(image.at(x * across + i, y * down + j)[c]);
                small.at(x, y)[c] = static_cast<float>(sum / (double(across) * down));
            }
    return small;
}

void addMethods(std::vector<PlanVariant>& variants, const Scene& scene, const Settings& base)
{
    const bool balls = std::ranges::any_of(scene.lights, [](const Light& light) { return light.radius > 0.0; });
    for (const Slot slot : brdf::allSlots()) {
        if (slot == Slot::model || !base.methods[slot] || (slot == Slot::areaLight && !balls))
            continue;
        for (const brdf::Method* method : methodsOf(slot)) {
            if (method == base.methods[slot] || !whyNotDrawn(*method).empty())
                continue;
            Settings settings = base;
            settings.methods[slot] = method;
            variants.push_back({fmt::format("{}={}", brdf::slotName(slot), method->id),
                                std::string(brdf::slotName(slot)), settings, 0});
        }
    }
}

void addNumbers(std::vector<PlanVariant>& variants, const Scene& scene, const Settings& base)
{
    for (const int directions : {16, 256}) {
        Settings settings = base;
        settings.methods[Slot::environmentSpecular] = brdf::findMethod(Slot::environmentSpecular, "vndf_bounded");
        settings.environmentSamples = directions;
        if (scene.environment)
            variants.push_back(
                {fmt::format("vndf_bounded, {} directions", directions), "environment_samples", settings, 0});
    }
    for (const int samples : {4, 16}) {
        Settings settings = base;
        settings.samples = samples;
        variants.push_back({fmt::format("{} samples", samples), "samples", settings, 0});
    }
    if (scene.shapes.empty()) {
        Settings settings = base;
        settings.samples = 4;
        settings.methods[Slot::pixelSampling] = brdf::findMethod(Slot::pixelSampling, "reconstructed");
        variants.push_back({"4 samples, reconstructed", "samples", settings, 0});
    }
    constexpr int kLeastWidth = 64;
    if (scene.environment)
        for (int width = scene.environment->radiance.width / 2, i = 0; width >= kLeastWidth && i < 3; width /= 2, ++i)
            variants.push_back({fmt::format("environment {} wide", width), "environment_size", base, width});
}

void addPaths(std::vector<PlanVariant>& variants, const Settings& base)
{
    struct Named
    {
        RenderPath path;
        const char* name;
    };
    for (const Named& named : {Named{RenderPath::forward, "forward"}, Named{RenderPath::prepass, "prepass"},
                               Named{RenderPath::attributes, "attributes"}, Named{RenderPath::deferred, "deferred"}})
    {
        Settings settings = base;
        settings.path = named.path;
        variants.push_back({fmt::format("path={}", named.name), "path", settings, 0});
    }
}

bool canBePlanned(const Scene& scene, const PlanVariant& variant)
{
    try {
        makePlan(scene, variant.settings);
        return true;
    } catch (const Error& error) {
        if (error.exitCode != ExitCode::usage)
            throw;
        return false; // methods that no table was made for together
    }
}

// A plan on the device.
struct Drawn
{
    Drawn(const TrialDevice& on, const Scene& s, const PlanVariant& variant)
        : scene(s), settings(variant.settings), renderer(on.device, on.shaders, on.cacheFolder)
    {
        if (variant.environmentWidth > 0)
            scene.environment->radiance =
                reduced(s.environment->radiance, s.environment->radiance.width / variant.environmentWidth);
        plan = makePlan(scene, settings);
        uploaded.emplace(renderer.upload(scene, plan));
    }
    Drawn(const Drawn&) = delete;

    TimeUse frame(const Camera& camera)
    {
        const TimeUse start = timeUse();
        if (pictureCount(settings) == 1) {
            renderer.drawFrame(*uploaded, camera);
            return timeUse() - start;
        }
        TimeUse end = start; // what follows the last sample is reading back
        renderer.render(*uploaded, camera, [&](int, int) { end = timeUse(); });
        return end - start;
    }

    /// Every sample shaded.
    Image supersampled(const Camera& camera, int samples, const std::function<void()>& checkpoint)
    {
        plan.settings.samples = samples;
        plan.settings.methods.pixelSampling = brdf::findMethod(Slot::pixelSampling, "supersampled");
        Image color = picture(camera, checkpoint);
        plan.settings = settings;
        return color;
    }

    Image picture(const Camera& camera, const std::function<void()>& checkpoint)
    {
        return renderer.render(*uploaded, camera, [&](int, int) { checkpoint(); }).color;
    }

    Scene scene;
    Settings settings;
    ShadingPlan plan;
    Renderer renderer;
    std::optional<DeviceScene> uploaded;
};

double distance(const float* a, const float* b)
{
    double sum = 0.0;
    for (int c = 0; c < 3; ++c)
        sum += std::abs(double(a[c]) - double(b[c]));
    return sum;
}

double norm(const float* a)
{
    return std::abs(double(a[0])) + std::abs(double(a[1])) + std::abs(double(a[2]));
}

// Over pixels that count: the sum of |d - c|_1 over that of |c|_1, and each pixel's own.
double relativeError(const Image& drawn, const Image& exact, const std::vector<bool>& counted, Image* pixels)
{
    double differences = 0.0, norms = 0.0, count = 0.0;
    for (std::size_t i = 0; i < counted.size(); ++i) {
        if (!counted[i])
            continue;
        const float* d = drawn.texels.data() + i * static_cast<std::size_t>(drawn.channels);
        const float* c = exact.texels.data() + i * static_cast<std::size_t>(exact.channels);
        differences += distance(d, c);
        norms += norm(c);
        count += 1.0;
    }
    for (std::size_t i = 0; pixels && i < counted.size(); ++i)
        if (counted[i]) {
            const float* d = drawn.texels.data() + i * static_cast<std::size_t>(drawn.channels);
            const float* c = exact.texels.data() + i * static_cast<std::size_t>(exact.channels);
            pixels->texels[i] = static_cast<float>(distance(d, c) / (norm(c) + kPixelFloor * norms / count));
        }
    return norms > 0.0 ? differences / norms : 0.0;
}

constexpr int kHoverSide = 192;

int reductionOf(const Image& image)
{
    return std::max(1, (std::max(image.width, image.height) + kHoverSide - 1) / kHoverSide);
}

std::string encoded(const Image& display)
{
    return base64(encodePng(display, 8));
}

std::vector<bool> frontOf(const std::vector<PlanResult>& results, bool both)
{
    std::vector<CostAndError> points;
    for (const PlanResult& r : results)
        points.push_back({r.milliseconds, r.shading + (both ? r.sampling : 0.0)});
    std::vector<bool> front(results.size(), false);
    for (const std::size_t i : paretoFront(points))
        front[i] = true;
    return front;
}

std::string percent(double share)
{
    return fmt::format("{:.3g} %", 100.0 * share);
}

ChartPanel frontPanel(const std::vector<PlanResult>& results, bool both)
{
    const std::vector<bool> front = frontOf(results, both);
    ChartPanel panel = {.id = both ? "both" : "shading",
                        .kind = ChartKind::front,
                        .title = both ? "Shading and sampling together" : "Shading",
                        .text = both ? "The sum of both parts: the most that they can come to."
                                     : "Against the exact light of the same surfaces. What samples and paths change "
                                       "is cost alone.",
                        .x = "ms a frame",
                        .y = "mean relative error",
                        .marks = {},
                        .columns = {},
                        .rows = {},
                        .frontRows = {}};
    for (std::size_t i = 0; i < results.size(); ++i) {
        const PlanResult& r = results[i];
        panel.marks.push_back({.name = r.name,
                               .label = r.name,
                               .group = "front",
                               .x = r.milliseconds,
                               .interval = std::nullopt,
                               .y = r.shading + (both ? r.sampling : 0.0),
                               .front = front[i],
                               .chosen = r.name == kStandard,
                               .details = {{"shading", percent(r.shading)},
                                           {"sampling", percent(r.sampling)},
                                           {"ms a frame", fmt::format("{:.3g}", r.milliseconds)},
                                           {"times standard", fmt::format("{:.3g} [{:.3g}, {:.3g}]", r.ratio.median,
                                                                          r.ratio.low, r.ratio.high)}},
                               .picture = r.picture,
                               .error = r.error,
                               .citation = {}});
    }
    return panel;
}

ChartPanel barsPanel(const std::vector<PlanResult>& results)
{
    const std::vector<bool> front = frontOf(results, true);
    ChartPanel panel = {.id = "budget",
                        .kind = ChartKind::bars,
                        .title = "Where the error comes from",
                        .text =
                            "Shading: of formulas, tables and prefilters. Sampling: of few places in a pixel, against "
                            "many. Light between surfaces (transport) is measured by neither.",
                        .x = "mean relative error",
                        .y = "",
                        .marks = {},
                        .columns = {"plan", "ms a frame", "times standard", "shading", "sampling", "varies"},
                        .rows = {},
                        .frontRows = front};
    for (const PlanResult& r : results) {
        for (const auto& [part, value] : {std::pair("shading", r.shading), std::pair("sampling", r.sampling)})
            panel.marks.push_back({.name = r.name,
                                   .label = r.name,
                                   .group = part,
                                   .x = r.milliseconds,
                                   .interval = std::nullopt,
                                   .y = value,
                                   .front = false,
                                   .chosen = r.name == kStandard,
                                   .details = {{part, percent(value)}},
                                   .picture = {},
                                   .error = {},
                                   .citation = {}});
        panel.rows.push_back({r.name, fmt::format("{:.3g}", r.milliseconds),
                              fmt::format("{:.3g} [{:.3g}, {:.3g}]", r.ratio.median, r.ratio.low, r.ratio.high),
                              percent(r.shading), percent(r.sampling), r.kind});
    }
    return panel;
}

} // namespace

std::vector<PlanVariant> planVariants(const Scene& scene, const Settings& base)
{
    std::vector<PlanVariant> all = {{kStandard, "preset", base, 0}};
    Settings gltf = base;
    gltf.methods = *brdf::findPreset("gltf");
    all.push_back({"gltf", "preset", gltf, 0});
    addMethods(all, scene, base);
    addNumbers(all, scene, base);
    addPaths(all, base);
    std::vector<PlanVariant> variants;
    for (PlanVariant& variant : all)
        if (canBePlanned(scene, variant))
            variants.push_back(std::move(variant));
    return variants;
}

PlanResult measurePlan(const TrialDevice& on, const Scene& scene, const Camera& camera, const PlanVariant& first,
                       const PlanVariant& variant, const SurfaceTruth& truth, const BenchBounds& bounds,
                       const std::function<void()>& checkpoint)
{
    Drawn base(on, scene, first), drawn(on, scene, variant);
    const auto frame = [&](Drawn& of) {
        checkpoint();
        return of.frame(camera);
    };
    frame(base); // with the driver's compilation
    frame(drawn);
    const std::vector<std::function<TimeUse()>> draws = {[&] { return frame(base); }, [&] { return frame(drawn); }};
    const std::vector<FrameTimes> times = timeFrames(draws, bounds, on.clock());
    const std::vector<double>&baseTimes = times[0].of(on.clock()), &ownTimes = times[1].of(on.clock());
    const Estimate ratio = estimatePairedRatio(baseTimes, ownTimes);
    const Image one = drawn.supersampled(camera, 1, checkpoint);
    const Image many = drawn.supersampled(camera, kManyPlanSamples, checkpoint);
    const Image own = variant.settings.samples == 1 ? one : drawn.picture(camera, checkpoint);
    Image pixels(one.width, one.height, 1);
    PlanResult result = {.name = variant.name,
                         .kind = variant.kind,
                         .milliseconds = 1e3 * median(ownTimes),
                         .ratio = {ratio.median, ratio.low, ratio.high},
                         .shading = relativeError(one, truth.color, truth.counted, &pixels),
                         .sampling = relativeError(own, many, truth.counted, nullptr),
                         .picture = {},
                         .error = {}};
    result.picture = encoded(toDisplay(reduced(own, reductionOf(own)), {}));
    result.error = encoded(errorPicture(reduced(pixels, reductionOf(pixels))));
    return result;
}

Json asJson(const PlanResult& r)
{
    return Json::Object{
        {"name", r.name},
        {"kind", r.kind},
        {"ms", r.milliseconds},
        {"ratio", Json::Object{{"median", r.ratio.median}, {"low", r.ratio.low}, {"high", r.ratio.high}}},
        {"shading", r.shading},
        {"sampling", r.sampling},
        {"picture", r.picture},
        {"error", r.error}};
}

PlanResult planResultFrom(const JsonView& json)
{
    const JsonView ratio = json.member("ratio");
    return {.name = json.member("name").text(),
            .kind = json.member("kind").text(),
            .milliseconds = json.member("ms").number(),
            .ratio = {ratio.member("median").number(), ratio.member("low").numberOr(-HUGE_VAL),
                      ratio.member("high").numberOr(HUGE_VAL)},
            .shading = json.member("shading").number(),
            .sampling = json.member("sampling").number(),
            .picture = json.member("picture").text(),
            .error = json.member("error").text()};
}

std::string plansCsv(const std::vector<PlanResult>& results)
{
    const std::vector<bool> front = frontOf(results, true);
    std::string text = "plan,kind,ms,ratio,ratio_low,ratio_high,shading,sampling,front\n";
    for (std::size_t i = 0; i < results.size(); ++i) {
        const PlanResult& r = results[i];
        text +=
            fmt::format("{},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{}\n", csvCell(r.name), r.kind, r.milliseconds,
                        r.ratio.median, r.ratio.low, r.ratio.high, r.shading, r.sampling, front[i] ? 1 : 0);
    }
    return text;
}

ChartPage plansPage(const std::string& scene, const std::string& about, const std::vector<PlanResult>& results)
{
    return {
        .title = "What plans of " + scene + " cost, and how far off they are",
        .introduction = {about,
                         "Each plan differs from the preset standard in one thing. Cost: its frames in turn with "
                         "standard's. Shading error: the sum of |d - c| over that of |c|, d one sample a pixel and c "
                         "the exact integral of the preset standard over the surfaces that the device found. "
                         "Blended surfaces do not count. Coloured: on the front. Diamond: what is drawn by default."},
        .panels = {frontPanel(results, true), frontPanel(results, false), barsPanel(results)}};
}

} // namespace torrance
