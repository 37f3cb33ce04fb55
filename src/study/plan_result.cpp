#include "study/plan_result.h"

#include "files/image_encoders.h"
#include "image/display.h"
#include "math/norm.h"
#include "measure/image_metrics.h"
#include "study/base64.h"
#include "study/error_picture.h"
#include "study/pixel_error.h"
#include "study/timed_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace torrance {
namespace {

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

    TimeUse frame(const Camera& camera) { return timeOfFrame(renderer, *uploaded, camera); }

    /// Every sample shaded.
    Image supersampled(const Camera& camera, int samples, const std::function<void()>& checkpoint)
    {
        plan.settings.samples = samples;
        plan.settings.methods.pixelSampling = brdf::findMethod(brdf::Slot::pixelSampling, "supersampled");
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

// Over pixels that count: the sum of |d - c|_1 over that of |c|_1.
double relativeError(const Image& drawn, const Image& exact, const std::vector<bool>& counted)
{
    double differences = 0.0, norms = 0.0;
    for (std::size_t i = 0; i < counted.size(); ++i) {
        if (!counted[i])
            continue;
        const float* d = drawn.texels.data() + i * static_cast<std::size_t>(drawn.channels);
        const float* c = exact.texels.data() + i * static_cast<std::size_t>(exact.channels);
        differences += distance1(d, c, 3);
        norms += norm1(c, 3);
    }
    return norms > 0.0 ? differences / norms : 0.0;
}

struct ShadingError
{
    double mean = 0.0;
    Image pixels; // each pixel's own
};

// The same where the truth is known through estimates: their noise is taken out, as far as it can be.
ShadingError shadingError(const Image& drawn, const SurfaceTruth& truth)
{
    ShadingError error = {0.0, Image(drawn.width, drawn.height, 1)};
    std::vector<PixelError> pixels(truth.counted.size());
    double above = 0.0, below = 0.0, variance = 0.0, norms = 0.0, count = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!truth.counted[i])
            continue;
        const float* d = drawn.texels.data() + i * static_cast<std::size_t>(drawn.channels);
        pixels[i] = pixelError(dvec3(d[0], d[1], d[2]), truth.light[i]);
        above += pixels[i].above;
        below += pixels[i].below;
        variance += pixels[i].errorVariance;
        norms += pixels[i].norm;
        count += 1.0;
    }
    if (norms <= 0.0)
        return error;
    // As PixelError::middle, of the sums. What lies within its own standard error of 0 cannot be told from that.
    error.mean = std::sqrt(above * std::max(below, std::sqrt(variance))) / norms;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (truth.counted[i])
            error.pixels.texels[i] =
                static_cast<float>(pixels[i].middle() / (pixels[i].norm + kPixelFloor * norms / count));
    return error;
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

} // namespace

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
    const ShadingError shading = shadingError(one, truth);
    PlanResult result = {.name = variant.name,
                         .kind = variant.kind,
                         .milliseconds = 1e3 * median(ownTimes),
                         .ratio = {ratio.median, ratio.low, ratio.high},
                         .shading = shading.mean,
                         .sampling = relativeError(own, many, truth.counted),
                         .picture = {},
                         .error = {}};
    result.picture = encoded(toDisplay(reduced(own, reductionOf(own)), {}));
    result.error = encoded(errorPicture(reduced(shading.pixels, reductionOf(shading.pixels))));
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

} // namespace torrance
