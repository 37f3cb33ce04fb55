#include "study/bench.h"

#include "files/csv_read.h"
#include "plan/path_plan.h"

#include <algorithm>
#include <fmt/format.h>

namespace torrance {
namespace {

std::vector<BenchPass> timePasses(BenchItem& item, double seconds)
{
    std::vector<PassTimes> times;
    const double start = timeUse().wall;
    constexpr int kMostFrames = 100; // for the picture of a frame's parts, not for their last per cent
    constexpr double kLeastSeconds = 0.2;
    for (int i = 0; i < kMostFrames && (i == 0 || timeUse().wall - start < std::max(seconds, kLeastSeconds)); ++i)
        item.drawPasses(times);
    std::vector<BenchPass> passes;
    for (const PassTimes& pass : times)
        passes.push_back({pass.name, estimateMedian(pass.processor), estimateMedian(pass.wall)});
    return passes;
}

} // namespace

BenchResult describe(const TimedItem& timed)
{
    const Settings& settings = timed.source.settings;
    const BenchItem& item = *timed.item;
    BenchResult result;
    result.name = timed.source.name;
    result.width = settings.width;
    result.height = settings.height;
    result.samples = settings.samples;
    result.path = nameOf(item.shadingPlan().path);
    result.methods = methodsText(settings.methods);
    result.triangles = triangleCount(item.drawnScene());
    result.draws = drawCount(item.shadingPlan());
    result.pipelines = item.pipelineCount();
    result.startUp = item.startUp();
    result.heldBytes = item.heldBytes();
    return result;
}

BenchRun runBench(std::vector<TimedItem>& items, std::vector<BenchResult> described, const BenchBounds& bounds,
                  BenchClock clock, const std::function<void(double)>& progress)
{
    std::vector<std::function<TimeUse()>> draws;
    for (TimedItem& timed : items)
        draws.push_back([&item = *timed.item] { return item.drawFrame(); });
    const double start = timeUse().wall;
    BenchRun run = {.results = std::move(described), .frames = {}};
    run.frames = timeFrames(draws, bounds, clock, [&](int) {
        if (progress)
            progress(timeUse().wall - start);
    });
    const double passSeconds = 0.25 * (timeUse().wall - start) / static_cast<double>(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        BenchResult& result = run.results[i];
        const FrameTimes& frames = run.frames[i];
        result.processor = estimateMedian(frames.processor);
        result.wall = estimateMedian(frames.wall);
        result.settled = isSettled(result.of(clock), bounds);
        if (i > 0)
            result.ratio = estimatePairedRatio(run.frames[0].of(clock), frames.of(clock));
        result.passes = timePasses(*items[i].item, passSeconds);
    }
    return run;
}

std::string framesAsCsv(const BenchRun& run)
{
    constexpr double kMilliseconds = 1000.0;
    std::string text = "item,frame,cpu_ms,wall_ms\n";
    for (std::size_t i = 0; i < run.results.size(); ++i)
        for (std::size_t frame = 0; frame < run.frames[i].wall.size(); ++frame)
            text +=
                fmt::format("{},{},{:.4f},{:.4f}\n", csvCell(run.results[i].name), frame,
                            run.frames[i].processor[frame] * kMilliseconds, run.frames[i].wall[frame] * kMilliseconds);
    return text;
}

std::string methodsText(const brdf::Preset& methods)
{
    std::string text(methods.id);
    for (const brdf::Slot slot : brdf::allSlots())
        if (const brdf::Method* method = methods[slot])
            text.append(" ").append(method->id);
    for (const brdf::ModelOption& option : brdf::allModelOptions())
        if (option.model == methods.model->id)
            text += fmt::format(" {}={}", option.id,
                                option.isQuirk()
                                    ? double(methods.options.*std::get<bool brdf::ModelOptions::*>(option.member))
                                    : methods.options.*std::get<double brdf::ModelOptions::*>(option.member));
    return text;
}

} // namespace torrance
