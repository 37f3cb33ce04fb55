#include "core/parallel.h"

#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace torrance {
namespace {

// More workers than a small machine has cores, so that waiting for one another would show. Before anything asks.
const int kThreadsAreSet = setenv("TORRANCE_THREADS", "4", 1);

TEST(Parallel, TakesTheNumberOfThreadsFromTheEnvironment)
{
    ASSERT_EQ(kThreadsAreSet, 0);
    EXPECT_EQ(workerCount(), 4u);
}

TEST(Parallel, DoesEveryItemOnce)
{
    for (const std::size_t count : {0u, 1u, 2u, 7u, 64u, 1000u})
        for (const std::size_t grain : {0u, 1u, 3u, 64u, 5000u}) {
            std::vector<std::atomic<int>> done(count);
            parallelFor(count, grain, [&](std::size_t i) { ++done[i]; });
            for (const auto& times : done)
                ASSERT_EQ(times, 1) << count << " items, " << grain << " at a time";
        }
}

TEST(Parallel, CutsRangesAtMultiplesOfTheGrain)
{
    std::mutex mutex;
    std::set<std::pair<std::size_t, std::size_t>> ranges;
    parallelRanges(10, 4, [&](std::size_t first, std::size_t last) {
        const std::lock_guard lock(mutex);
        ranges.emplace(first, last);
    });
    EXPECT_EQ(ranges, (std::set<std::pair<std::size_t, std::size_t>>{{0, 4}, {4, 8}, {8, 10}}));
}

// Each of 8 items waits for 8 inner ones, and each of those for 8 more: with 4 threads most callers wait at some time.
TEST(Parallel, NestsWithoutWaitingInACircle)
{
    for (int round = 0; round < 50; ++round) {
        std::atomic<int> done = 0;
        parallelFor(8, 1, [&](std::size_t) {
            parallelFor(8, 1, [&](std::size_t) { parallelFor(8, 1, [&](std::size_t) { ++done; }); });
        });
        ASSERT_EQ(done, 8 * 8 * 8);
    }
}

TEST(Parallel, ServesSeveralCallersAtOnce)
{
    std::atomic<int> done = 0;
    std::vector<std::jthread> callers;
    for (int i = 0; i < 6; ++i)
        callers.emplace_back([&] {
            for (int round = 0; round < 100; ++round)
                parallelFor(5, 1, [&](std::size_t) { ++done; });
        });
    callers.clear();
    EXPECT_EQ(done, 6 * 100 * 5);
}

TEST(Parallel, KeepsItsThreads)
{
    std::mutex mutex;
    std::set<std::thread::id> seen;
    for (int round = 0; round < 200; ++round)
        parallelFor(8, 1, [&](std::size_t) {
            const std::lock_guard lock(mutex);
            seen.insert(std::this_thread::get_id());
        });
    EXPECT_LE(seen.size(), workerCount());
}

// All four wait for each other: with fewer at work this would wait for ever.
TEST(Parallel, WorksOnAllThreadsAtOnce)
{
    std::atomic<std::size_t> arrived = 0;
    parallelFor(workerCount(), 1, [&](std::size_t) {
        ++arrived;
        while (arrived < workerCount())
            std::this_thread::yield();
    });
    EXPECT_EQ(arrived, workerCount());
}

TEST(Parallel, RethrowsAndGoesOnWorking)
{
    for (int round = 0; round < 20; ++round) {
        std::atomic<int> done = 0;
        EXPECT_THROW(parallelFor(1000, 1,
                                 [&](std::size_t i) {
                                     ++done;
                                     if (i == 3)
                                         throw std::runtime_error("item 3");
                                 }),
                     std::runtime_error);
        EXPECT_GE(done, 1);
        EXPECT_LE(done, 1000);
    }
    EXPECT_THROW(
        parallelFor(4, 1,
                    [](std::size_t) { parallelFor(4, 1, [](std::size_t) { throw std::runtime_error("inner"); }); }),
        std::runtime_error);
    std::atomic<int> done = 0;
    parallelFor(100, 1, [&](std::size_t) { ++done; });
    EXPECT_EQ(done, 100);
}

} // namespace
} // namespace torrance
