// What a frame, its preparation and its memory cost as a scene or a picture grows.
#pragma once

#include "files/json_write.h"
#include "measure/growth_fit.h"
#include "passes/renderer.h"
#include "study/bench_frames.h"
#include "study/bench_record.h"
#include "study/growth_scenes.h"

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace torrance {

/// What is measured of one size, each by a member of GrowthSample.
enum class GrowthCost
{
    frame,       // seconds
    preparation, // seconds: plan and upload
    memory,      // bytes of its own, beyond those before the series, the scene as it was loaded included
};

inline constexpr std::array kGrowthCosts = {GrowthCost::frame, GrowthCost::preparation, GrowthCost::memory};

std::string_view nameOf(GrowthCost cost);

struct GrowthSample
{
    TimeUse frame;
    TimeUse preparation;
    double bytes = 0.0;

    double of(GrowthCost cost, BenchClock clock) const;
};

struct GrowthMeasurement
{
    const GrowthSeries* series = nullptr;
    std::vector<std::vector<GrowthSample>> rounds; // each with a sample for every size of the series
    std::vector<std::size_t> draws;                // calls that draw a frame, by size

    GrowthFit fit(GrowthCost cost, BenchClock clock) const;
    /// Over the rounds.
    Estimate at(std::size_t size, GrowthCost cost, BenchClock clock) const;
};

/// Nine rounds give an interval that leaves one out on each side.
inline constexpr int kGrowthRounds = 9;

/// Every size once a round, in ascending order, on a device and with a renderer of the round's own: drivers keep memory
/// for the next frame that is as large. `bounds.frames` rounds, or kGrowthRounds; none begins when `bounds.seconds` a
/// size are over. At least one.
GrowthMeasurement measureGrowth(const std::function<gpu::Device()>& openDevice, gpu::ShaderLibrary& shaders,
                                const std::filesystem::path& cacheFolder, const GrowthSeries& series,
                                const Settings& settings, const std::optional<Environment>& environment,
                                const BenchBounds& bounds, const std::function<void(int done, int all)>& progress = {});

/// Whether any of the costs grows by more than in proportion.
bool growsTooFast(const GrowthMeasurement& measurement, BenchClock clock);

struct GrowthRecord
{
    BenchRecord bench; // without results
    std::vector<GrowthMeasurement> series;
};

inline constexpr std::string_view kGrowthSchema = "torrance-bench-growth/1";

/// Times in milliseconds, memory in MiB; slopes in nanoseconds and bytes a unit.
Json asJson(const GrowthRecord& record);

/// "series,size,round,frame_cpu_ms,frame_wall_ms,preparation_cpu_ms,preparation_wall_ms,memory_mib", a row a sample.
std::string growthCsv(const std::vector<GrowthMeasurement>& measurements);

} // namespace torrance
