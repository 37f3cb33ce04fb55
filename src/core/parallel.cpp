#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <sched.h>
#include <system_error>
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

using RangeWork = std::function<void(std::size_t, std::size_t)>;

// One call of parallelRanges, on its caller's stack. Whoever has time takes ranges from it.
struct Job
{
    Job(const RangeWork& rangeWork, std::size_t itemCount, std::size_t itemsAtATime)
        : work(rangeWork), count(itemCount), grain(itemsAtATime)
    {
    }

    bool hasRanges() const { return next < count; }

    void takeRanges()
    {
        for (;;) {
            const std::size_t first = next.fetch_add(grain);
            if (first >= count)
                return;
            try {
                work(first, std::min(first + grain, count));
            } catch (...) {
                const std::lock_guard lock(failureMutex);
                if (!failure)
                    failure = std::current_exception();
                next = count; // the others stop at their next range
            }
        }
    }

    const RangeWork& work;
    const std::size_t count, grain;
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex failureMutex;
    std::size_t helpers = 0; // under the pool's mutex
    std::condition_variable left;
};

// Threads that live as long as the process. A caller always works on its own job and waits for nothing but ranges that
// somebody is at work on, so that jobs within jobs cannot wait for each other in a circle.
class Pool
{
public:
    explicit Pool(std::size_t threadCount)
    {
        try {
            for (std::size_t i = 0; i < threadCount; ++i)
                threads.emplace_back([this] { help(); });
        } catch (const std::system_error&) { // no more threads are to be had: fewer do the same work
        }
    }

    ~Pool()
    {
        const std::lock_guard lock(mutex);
        stopping = true;
        wake.notify_all();
    }

    void run(Job& job)
    {
        {
            const std::lock_guard lock(mutex);
            jobs.push_back(&job);
        }
        const std::size_t ranges = (job.count - 1) / job.grain + 1;
        for (std::size_t i = 1; i < std::min(ranges, threads.size() + 1); ++i)
            wake.notify_one();
        job.takeRanges();
        std::unique_lock lock(mutex);
        std::erase(jobs, &job);
        job.left.wait(lock, [&] { return job.helpers == 0; });
    }

private:
    // The oldest first: the outer job of two has the larger pieces.
    Job* open() const
    {
        const auto found = std::ranges::find_if(jobs, &Job::hasRanges);
        return found == jobs.end() ? nullptr : *found;
    }

    void help()
    {
        std::unique_lock lock(mutex);
        for (;;) {
            Job* job = nullptr;
            wake.wait(lock, [&] { return stopping || (job = open()) != nullptr; });
            if (stopping)
                return;
            ++job->helpers;
            lock.unlock();
            job->takeRanges();
            lock.lock();
            if (--job->helpers == 0)
                job->left.notify_all(); // under the lock: the job is gone once its caller has it
        }
    }

    std::mutex mutex;
    std::condition_variable wake;
    std::vector<Job*> jobs;
    bool stopping = false;
    std::vector<std::jthread> threads; // last: they are joined while what they use is still there
};

Pool& pool()
{
    static Pool threads(workerCount() - 1);
    return threads;
}

} // namespace

std::size_t workerCount()
{
    static const std::size_t count = countWorkers();
    return count;
}

void parallelRanges(std::size_t count, std::size_t grain, const RangeWork& work)
{
    Job job(work, count, std::max<std::size_t>(grain, 1));
    if (count <= job.grain || workerCount() == 1)
        job.takeRanges();
    else
        pool().run(job);
    if (job.failure)
        std::rethrow_exception(job.failure);
}

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t)>& work)
{
    parallelRanges(count, grain, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            work(i);
    });
}

} // namespace torrance
