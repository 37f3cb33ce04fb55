// Pictures timed side by side.
#pragma once

#include "study/bench_frames.h"
#include "study/bench_item.h"
#include "study/bench_record.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace torrance {

struct TimedItem
{
    BenchSource source;
    std::unique_ptr<BenchItem> item;
};

/// All of a result that is not measured frame by frame, without BenchResult::path.
BenchResult describe(const TimedItem& timed);

struct BenchRun
{
    std::vector<BenchResult> results; // in the order of the items
    std::vector<FrameTimes> frames;   // of each, in the order in which they were drawn
};

/// Frames of all items in turn, then each item's passes for a quarter of the time. There is at least one item;
/// `described` is describe() of each.
BenchRun runBench(std::vector<TimedItem>& items, std::vector<BenchResult> described, const BenchBounds& bounds,
                  BenchClock clock, const std::function<void(double seconds)>& progress = {});

/// "item,frame,cpu_ms,wall_ms", a row a frame.
std::string framesAsCsv(const BenchRun& run);

/// "standard: ggx, smith_corr, ...": methods that differ have other texts.
std::string methodsText(const brdf::Preset& methods);

} // namespace torrance
