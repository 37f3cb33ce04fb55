#include "study/soak.h"

#include "measure/timing_statistics.h"

#include <cassert>

namespace torrance {
namespace {

double medianBytes(std::span<const MemoryUse> readings)
{
    std::vector<double> bytes;
    for (const MemoryUse& reading : readings)
        bytes.push_back(static_cast<double>(reading.own));
    return median(bytes);
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
    const double before = medianBytes(readings.subspan(kSoakWarmUp - kSoakWindow, kSoakWindow));
    const double after = medianBytes(readings.last(kSoakWindow));
    return {.bytesAfterWarmUp = before, .bytesAtEnd = after, .growth = after / before - 1.0};
}

} // namespace torrance
