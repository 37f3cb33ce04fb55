// Frames timed until their median is known, several things in turn.
#pragma once

#include "core/process_usage.h"
#include "measure/timing_statistics.h"

#include <functional>
#include <span>
#include <vector>

namespace torrance {

/// Which of the two decides. Where the processor draws, its time is the whole cost and hardly changes with what else
/// the machine does; where a GPU draws, it says nothing.
enum class BenchClock
{
    processor,
    wall,
};

struct BenchBounds
{
    int frames = 0;        // the most of each; 0: any number
    double seconds = 20.0; // on the wall, for each that is timed; the round that is running is finished
    double width = 0.02;   // enough: the interval of every median, against it
};

/// Seconds, frame by frame.
struct FrameTimes
{
    std::vector<double> processor;
    std::vector<double> wall;

    const std::vector<double>& of(BenchClock clock) const { return clock == BenchClock::wall ? wall : processor; }
};

/// Fewer frames are not believed, however alike they are: 12 leave the interval without the two on each side.
inline constexpr int kLeastFrames = 12;

/// Times one frame of each in turn, each round beginning with another, so that what disturbs the machine disturbs all
/// alike and the frames of a round can be compared in pairs. As many frames of each, at least one. Ends where all
/// intervals are narrow, or at a bound.
std::vector<FrameTimes> timeFrames(std::span<const std::function<TimeUse()>> items, const BenchBounds& bounds,
                                   BenchClock clock, const std::function<void(int rounds)>& progress = {});

/// Whether the interval is as narrow as it was to be.
bool isSettled(const Estimate& estimate, const BenchBounds& bounds);

} // namespace torrance
