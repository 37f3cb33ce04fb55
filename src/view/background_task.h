// Work on a thread of its own whose result is fetched when it is there: a window does not wait.
#pragma once

#include "core/cancelled.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace torrance {

/// What the thread says of its work, and hears of it.
class Progress
{
public:
    /// The work comes to its part of this number, of all. Throws Cancelled.
    void enter(int part)
    {
        endWhereStopped(stopToken());
        current = part;
    }
    int part() const { return current; }
    void cancel() { stop.request_stop(); }
    bool isCancelled() const { return stop.stop_requested(); }
    /// For parts that look themselves whether they were cancelled.
    std::stop_token stopToken() const { return stop.get_token(); }

private:
    std::atomic<int> current = 0;
    std::stop_source stop;
};

/// At most one piece of work at a time. `announceEnd` is called from its thread once the result can be taken, not
/// before: a window that is woken, finds nothing and sleeps again would sleep on.
template <typename Result>
class BackgroundTask
{
public:
    explicit BackgroundTask(void (*announceEnd)()) : announce(announceEnd) {}

    template <typename Work> // Result(Progress&)
    void start(Work work)
    {
        progress = std::make_shared<Progress>();
        std::packaged_task<Result()> task(
            [work = std::move(work), state = progress]() mutable { return work(*state); });
        future = task.get_future();
        thread = std::jthread([task = std::move(task), end = announce]() mutable {
            task();
            end();
        });
    }

    bool isRunning() const { return future.valid(); } // or its result has not been taken
    bool isEnded() const
    {
        return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    }
    int part() const { return progress->part(); }
    void cancel() { progress->cancel(); }
    /// Until the work has ended, where there is some: take() has its result then.
    void wait() const
    {
        if (future.valid())
            future.wait();
    }

    /// The result, once; nothing while the work goes on, and where it was cancelled. Rethrows what the work threw.
    std::optional<Result> take()
    {
        if (!isEnded())
            return std::nullopt;
        try {
            Result result = future.get();
            if (progress->isCancelled())
                return std::nullopt;
            return result;
        } catch (const Cancelled&) {
            return std::nullopt;
        }
    }

private:
    void (*announce)();
    std::shared_ptr<Progress> progress;
    std::future<Result> future;
    std::jthread thread; // joined before what it fills goes
};

} // namespace torrance
