// What this process has used of the machine.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

namespace torrance {

/// Seconds on the processor, of all threads, and on the wall.
struct TimeUse
{
    double processor = 0.0;
    double wall = 0.0;
};

/// Since some fixed moment: what stands between two of them is what was used between.
TimeUse timeUse();
TimeUse operator-(const TimeUse& later, const TimeUse& earlier);

/// Bytes in memory. Zeros where the kernel does not say.
struct MemoryUse
{
    std::uint64_t proportional = 0; // PSS: a page that n processes share counts as 1/n
    std::uint64_t own = 0;          // of it what comes from no file: no other process's start or end changes it
    std::uint64_t allocated = 0; // and not given back: freed memory stays in the process, and hides what leaks into it
};

MemoryUse memoryUse();
/// The same when what was freed has been given back to the system: what is held, whatever was held before.
MemoryUse settledMemoryUse();

/// The most that was resident at once (VmHWM), shared pages counted whole.
std::uint64_t peakResidentBytes();

/// Notes the greatest PSS while it lives, on a thread of its own that rests most of the time: a reading walks the page
/// tables and takes milliseconds where much is resident.
class MemorySampler
{
public:
    MemorySampler();
    ~MemorySampler();
    MemorySampler(const MemorySampler&) = delete;
    MemorySampler& operator=(const MemorySampler&) = delete;

    /// The greatest that the thread has seen.
    std::uint64_t seen() const { return greatest; }
    /// The same, the present included.
    std::uint64_t peak();

private:
    void note();

    std::atomic<std::uint64_t> greatest = 0;
    std::jthread thread;
};

} // namespace torrance
