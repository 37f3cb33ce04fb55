// One process that draws for a long time: its memory must stay as it is.
#pragma once

#include "core/process_usage.h"

#include <functional>
#include <span>
#include <vector>

namespace torrance {

inline constexpr int kSoakWarmUp = 100;         // renders after which nothing may grow
inline constexpr int kSoakWindow = 10;          // renders whose median stands for one moment
inline constexpr double kMostSoakGrowth = 0.02; // of the memory after the warm-up

/// What the process holds after each render.
std::vector<MemoryUse> soak(int renders, const std::function<void(int render)>& render);

struct SoakVerdict
{
    MemoryUse afterWarmUp;
    MemoryUse atEnd;
    double growth = 0.0; // of what is its own or of what is allocated, whichever grew by more, against what was its own

    bool passed() const { return growth <= kMostSoakGrowth; }
};

/// From the medians of the last kSoakWindow readings of the warm-up and of all. More than kSoakWarmUp + kSoakWindow
/// readings.
SoakVerdict judgeSoak(std::span<const MemoryUse> readings);

} // namespace torrance
