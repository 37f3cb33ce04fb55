#include "study/bench_frames.h"

#include <algorithm>

namespace torrance {
namespace {

bool allSettled(std::span<const FrameTimes> times, const BenchBounds& bounds, BenchClock clock)
{
    return std::ranges::all_of(times,
                               [&](const FrameTimes& t) { return isSettled(estimateMedian(t.of(clock)), bounds); });
}

// Intervals that are looked at after every frame are caught at their narrowest, and hold the truth less often than they
// say: each look waits for an eighth more frames than the last.
int nextLook(int rounds)
{
    return rounds + std::max(rounds / 8, 1);
}

} // namespace

bool isSettled(const Estimate& estimate, const BenchBounds& bounds)
{
    return estimate.relativeWidth() <= bounds.width;
}

std::vector<FrameTimes> timeFrames(std::span<const std::function<TimeUse()>> items, const BenchBounds& bounds,
                                   BenchClock clock, const std::function<void(int)>& progress)
{
    std::vector<FrameTimes> times(items.size());
    const double start = timeUse().wall;
    const double mostSeconds = bounds.seconds * static_cast<double>(items.size());
    int look = kLeastFrames;
    for (int rounds = 0;;) {
        for (std::size_t i = 0; i < items.size(); ++i) {
            const std::size_t item = (i + static_cast<std::size_t>(rounds)) % items.size();
            const TimeUse use = items[item]();
            times[item].processor.push_back(use.processor);
            times[item].wall.push_back(use.wall);
        }
        ++rounds;
        if (progress)
            progress(rounds);
        if (rounds == bounds.frames || timeUse().wall - start >= mostSeconds)
            return times;
        if (rounds < look)
            continue;
        if (allSettled(times, bounds, clock))
            return times;
        look = nextLook(rounds);
    }
}

} // namespace torrance
