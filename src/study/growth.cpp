#include "study/growth.h"

#include "study/bench_item.h"

#include <algorithm>
#include <fmt/format.h>

namespace torrance {
namespace {

constexpr double kMilliseconds = 1000.0;
constexpr double kMebibyte = 1024.0 * 1024.0;
constexpr double kNanoseconds = 1e9;

// A short frame is drawn as often as fits this time, and its median taken.
constexpr double kFrameSeconds = 0.1;
constexpr int kMostFrames = 9;

TimeUse medianFrame(Renderer& renderer, const DeviceScene& scene, const Camera& camera)
{
    FrameTimes times;
    const double start = timeUse().wall;
    while (times.wall.empty() ||
           (times.wall.size() < std::size_t(kMostFrames) && timeUse().wall - start < kFrameSeconds)) {
        const TimeUse before = timeUse();
        renderer.drawFrame(scene, camera);
        const TimeUse use = timeUse() - before;
        times.processor.push_back(use.processor);
        times.wall.push_back(use.wall);
    }
    return {.processor = median(times.processor), .wall = median(times.wall)};
}

struct Point
{
    GrowthSample sample;
    std::size_t draws;
};

Point measurePoint(Renderer& renderer, const GrowthSeries& series, double size, Settings settings,
                   const std::optional<Environment>& environment, double bytesBefore)
{
    if (series.setPicture)
        series.setPicture(size, settings);
    Scene scene = series.makeScene(size);
    scene.environment = environment;
    const Camera camera = growthCamera(scene);
    settledMemoryUse(); // every size begins without what others have freed, as a process does
    const TimeUse start = timeUse();
    const ShadingPlan plan = makePlan(scene, settings);
    const DeviceScene onDevice = renderer.upload(scene, plan);
    Point point = {.sample = {.frame = {}, .preparation = timeUse() - start, .bytes = 0.0}, .draws = drawCount(plan)};
    renderer.drawFrame(onDevice, camera); // what is compiled or first touched
    point.sample.frame = medianFrame(renderer, onDevice, camera);
    point.sample.bytes = static_cast<double>(settledMemoryUse().own) - bytesBefore;
    return point;
}

std::vector<Point> measureRound(const gpu::Device& device, gpu::ShaderLibrary& shaders,
                                const std::filesystem::path& cacheFolder, const GrowthSeries& series,
                                const Settings& settings, const std::optional<Environment>& environment)
{
    const auto bytesBefore = static_cast<double>(settledMemoryUse().own);
    Renderer renderer(device, shaders, cacheFolder);
    std::vector<Point> points;
    // The first is not counted: it pays for compilation, the environment and the tables.
    measurePoint(renderer, series, series.sizes.front(), settings, environment, bytesBefore);
    for (const double size : series.sizes)
        points.push_back(measurePoint(renderer, series, size, settings, environment, bytesBefore));
    return points;
}

double unitOf(GrowthCost cost)
{
    return cost == GrowthCost::memory ? 1.0 / kMebibyte : kMilliseconds;
}

Json costAsJson(const GrowthMeasurement& measurement, GrowthCost cost, BenchClock clock)
{
    const GrowthFit fit = measurement.fit(cost, clock);
    Json::Array values;
    for (std::size_t i = 0; i < measurement.series->sizes.size(); ++i)
        values.push_back(asJson(measurement.at(i, cost, clock), unitOf(cost)));
    const bool memory = cost == GrowthCost::memory;
    return Json::Object{{memory ? "mib" : "ms", values},
                        {memory ? "constant_mib" : "constant_ms", asJson(fit.constant, unitOf(cost))},
                        {memory ? "bytes_a_unit" : "ns_a_unit", asJson(fit.slope, memory ? 1.0 : kNanoseconds)},
                        {"exponent", asJson(fit.exponent, 1.0)},
                        {"growth", std::string(nameOf(fit.kind))}};
}

Json seriesAsJson(const GrowthMeasurement& measurement, BenchClock clock)
{
    const GrowthSeries& series = *measurement.series;
    Json::Object object = {{"series", std::string(series.id)},
                           {"unit", std::string(series.unit)},
                           {"rounds", measurement.rounds.size()},
                           {"sizes", Json::Array(series.sizes.begin(), series.sizes.end())},
                           {"draws", Json::Array(measurement.draws.begin(), measurement.draws.end())}};
    for (const GrowthCost cost : kGrowthCosts)
        object.emplace_back(std::string(nameOf(cost)), costAsJson(measurement, cost, clock));
    return object;
}

} // namespace

std::string_view nameOf(GrowthCost cost)
{
    switch (cost) {
    case GrowthCost::frame:
        return "frame";
    case GrowthCost::preparation:
        return "preparation";
    case GrowthCost::memory:
        break;
    }
    return "memory";
}

double GrowthSample::of(GrowthCost cost, BenchClock clock) const
{
    if (cost == GrowthCost::memory)
        return bytes;
    const TimeUse& use = cost == GrowthCost::frame ? frame : preparation;
    return clock == BenchClock::wall ? use.wall : use.processor;
}

GrowthFit GrowthMeasurement::fit(GrowthCost cost, BenchClock clock) const
{
    std::vector<std::vector<double>> costs;
    for (const auto& round : rounds) {
        costs.emplace_back();
        for (const GrowthSample& sample : round)
            costs.back().push_back(sample.of(cost, clock));
    }
    return fitGrowth(series->sizes, costs);
}

Estimate GrowthMeasurement::at(std::size_t size, GrowthCost cost, BenchClock clock) const
{
    std::vector<double> values;
    for (const auto& round : rounds)
        values.push_back(round[size].of(cost, clock));
    return estimateMedian(values);
}

GrowthMeasurement measureGrowth(const std::function<gpu::Device()>& openDevice, gpu::ShaderLibrary& shaders,
                                const std::filesystem::path& cacheFolder, const GrowthSeries& series,
                                const Settings& settings, const std::optional<Environment>& environment,
                                const BenchBounds& bounds, const std::function<void(int, int)>& progress)
{
    GrowthMeasurement measurement = {.series = &series, .rounds = {}, .draws = {}};
    const double start = timeUse().wall, most = bounds.seconds * static_cast<double>(series.sizes.size());
    const int rounds = bounds.frames > 0 ? bounds.frames : kGrowthRounds;
    for (int round = 0; round < rounds && (round == 0 || timeUse().wall - start < most); ++round) {
        const gpu::Device device = openDevice();
        const std::vector<Point> points = measureRound(device, shaders, cacheFolder, series, settings, environment);
        measurement.rounds.emplace_back();
        measurement.draws.clear();
        for (const Point& point : points) {
            measurement.rounds.back().push_back(point.sample);
            measurement.draws.push_back(point.draws);
        }
        if (progress)
            progress(round + 1, rounds);
    }
    return measurement;
}

bool growsTooFast(const GrowthMeasurement& measurement, BenchClock clock)
{
    return std::ranges::any_of(
        kGrowthCosts, [&](GrowthCost cost) { return measurement.fit(cost, clock).kind == GrowthKind::superLinear; });
}

Json asJson(const GrowthRecord& record)
{
    Json::Object object = describedAsJson(record.bench, kGrowthSchema);
    Json::Array series;
    for (const GrowthMeasurement& measurement : record.series)
        series.push_back(seriesAsJson(measurement, record.bench.clock));
    object.emplace_back("series", series);
    return object;
}

std::string growthCsv(const std::vector<GrowthMeasurement>& measurements)
{
    std::string text =
        "series,size,round,frame_cpu_ms,frame_wall_ms,preparation_cpu_ms,preparation_wall_ms,memory_mib\n";
    for (const GrowthMeasurement& m : measurements)
        for (std::size_t round = 0; round < m.rounds.size(); ++round)
            for (std::size_t i = 0; i < m.series->sizes.size(); ++i) {
                const GrowthSample& s = m.rounds[round][i];
                text += fmt::format("{},{:.0f},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n", m.series->id,
                                    m.series->sizes[i], round, s.frame.processor * kMilliseconds,
                                    s.frame.wall * kMilliseconds, s.preparation.processor * kMilliseconds,
                                    s.preparation.wall * kMilliseconds, s.bytes / kMebibyte);
            }
    return text;
}

} // namespace torrance
