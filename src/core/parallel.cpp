#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <sched.h>
#include <thread>
#include <vector>

namespace torrance {
namespace {

constexpr std::size_t kMaxWorkers = 256; // more threads than this only cost memory

std::size_t countWorkers()
{
    if (const char* text = std::getenv("TORRANCE_THREADS")) {
        const long asked = std::strtol(text, nullptr, 10);
        if (asked > 0)
            return std::min<std::size_t>(static_cast<std::size_t>(asked), kMaxWorkers);
    }
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0)
        return std::clamp<std::size_t>(static_cast<std::size_t>(CPU_COUNT(&set)), 1, kMaxWorkers);
    return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMaxWorkers);
}

} // namespace

std::size_t workerCount()
{
    static const std::size_t count = countWorkers();
    return count;
}

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t)>& work)
{
    grain = std::max<std::size_t>(grain, 1);
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex failureMutex;

    const auto takeItems = [&] {
        for (;;) {
            const std::size_t first = next.fetch_add(grain);
            if (first >= count)
                return;
            try {
                for (std::size_t i = first; i < std::min(first + grain, count); ++i)
                    work(i);
            } catch (...) {
                const std::lock_guard lock(failureMutex);
                if (!failure)
                    failure = std::current_exception();
                next = count; // the others stop at their next item
            }
        }
    };

    const std::size_t chunks = (count + grain - 1) / grain;
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < std::min(workerCount(), chunks); ++i)
        helpers.emplace_back(takeItems);
    takeItems();
    helpers.clear(); // joins
    if (failure)
        std::rethrow_exception(failure);
}

} // namespace torrance
