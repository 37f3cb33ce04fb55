#include "study/soak.h"

#include "measure/timing_statistics.h"

#include <algorithm>
#include <cassert>

namespace torrance {
namespace {

MemoryUse medianUse(std::span<const MemoryUse> readings)
{
    const auto medianOf = [&](std::uint64_t MemoryUse::*member) {
        std::vector<double> bytes;
        for (const MemoryUse& reading : readings)
            bytes.push_back(static_cast<double>(reading.*member));
        return static_cast<std::uint64_t>(median(bytes));
    };
    return {.proportional = medianOf(&MemoryUse::proportional),
            .own = medianOf(&MemoryUse::own),
            .allocated = medianOf(&MemoryUse::allocated)};
}

double growthOf(std::uint64_t before, std::uint64_t after)
{
    return static_cast<double>(after) - static_cast<double>(before);
}

} // namespace

std::vector<MemoryUse> soak(int renders, const std::function<void(int)>& render)
{
    std::vector<MemoryUse> readings;
    readings.reserve(static_cast<std::size_t>(renders)); // so that the list itself does not grow
    for (int i = 0; i < renders; ++i) {
        render(i);
        readings.push_back(memoryUse());
    }
    return readings;
}

SoakVerdict judgeSoak(std::span<const MemoryUse> readings)
{
    assert(readings.size() > kSoakWarmUp + kSoakWindow);
    const MemoryUse before = medianUse(readings.subspan(kSoakWarmUp - kSoakWindow, kSoakWindow));
    const MemoryUse after = medianUse(readings.last(kSoakWindow));
    const double bytes = std::max(growthOf(before.own, after.own), growthOf(before.allocated, after.allocated));
    return {.afterWarmUp = before, .atEnd = after, .growth = bytes / static_cast<double>(before.own)};
}

} // namespace torrance
