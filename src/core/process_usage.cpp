#include "core/process_usage.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <ctime>
#include <fstream>
#include <malloc.h>
#include <mutex>
#include <sstream>
#include <string>
#include <string_view>

namespace torrance {
namespace {

double secondsOf(clockid_t clock)
{
    timespec time = {};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// A line of a file of /proc: "Pss:    1234 kB". 0 where it is not that line.
std::uint64_t bytesOf(const std::string& line, std::string_view name)
{
    if (line.compare(0, name.size(), name) != 0)
        return 0;
    constexpr std::uint64_t kKilobyte = 1024;
    std::uint64_t kilobytes = 0;
    std::istringstream(line.substr(name.size())) >> kilobytes;
    return kilobytes * kKilobyte;
}

// A sampler takes at most one part in so many of a core.
constexpr int kRest = 50;
constexpr std::chrono::milliseconds kLeastRest(10);

} // namespace

TimeUse timeUse()
{
    return {.processor = secondsOf(CLOCK_PROCESS_CPUTIME_ID), .wall = secondsOf(CLOCK_MONOTONIC)};
}

TimeUse operator-(const TimeUse& later, const TimeUse& earlier)
{
    return {.processor = later.processor - earlier.processor, .wall = later.wall - earlier.wall};
}

MemoryUse memoryUse()
{
    MemoryUse use;
    std::ifstream file("/proc/self/smaps_rollup");
    for (std::string line; std::getline(file, line);) {
        use.proportional += bytesOf(line, "Pss:");
        use.own += bytesOf(line, "Pss_Anon:") + bytesOf(line, "Pss_Shmem:");
    }
    const struct mallinfo2 heap = mallinfo2();
    use.allocated = heap.uordblks + heap.hblkhd; // in all arenas, and in pieces that were mapped by themselves
    return use;
}

MemoryUse settledMemoryUse()
{
    malloc_trim(0);
    return memoryUse();
}

std::uint64_t peakResidentBytes()
{
    std::uint64_t bytes = 0;
    std::ifstream file("/proc/self/status");
    for (std::string line; std::getline(file, line);)
        bytes += bytesOf(line, "VmHWM:");
    return bytes;
}

MemorySampler::MemorySampler()
    : thread([this](const std::stop_token& stop) {
          std::mutex mutex;
          std::condition_variable_any ended;
          std::unique_lock lock(mutex);
          while (!stop.stop_requested()) {
              const double start = timeUse().wall;
              note();
              const std::chrono::duration<double> rest(kRest * (timeUse().wall - start));
              ended.wait_for(lock, stop, std::max<std::chrono::duration<double>>(rest, kLeastRest),
                             [] { return false; });
          }
      })
{
}

MemorySampler::~MemorySampler() = default; // the thread is told to stop, and joined

void MemorySampler::note()
{
    const std::uint64_t now = memoryUse().proportional;
    std::uint64_t before = greatest;
    while (before < now && !greatest.compare_exchange_weak(before, now)) {
    }
}

std::uint64_t MemorySampler::peak()
{
    note();
    return greatest;
}

} // namespace torrance
