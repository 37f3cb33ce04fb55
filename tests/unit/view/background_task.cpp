#include "view/background_task.h"

#include <gtest/gtest.h>
#include <stdexcept>
#include <thread>

namespace torrance {
namespace {

std::atomic<int> announcements = 0;
void announce()
{
    ++announcements;
}

template <typename T>
std::optional<T> wait(BackgroundTask<T>& task)
{
    for (;;) {
        if (std::optional<T> result = task.take())
            return result;
        if (!task.isRunning())
            return std::nullopt;
        std::this_thread::yield();
    }
}

TEST(BackgroundTask, HandsItsResultOverOnceAndAnnouncesIt)
{
    announcements = 0;
    BackgroundTask<int> task(announce);
    EXPECT_FALSE(task.isRunning());
    task.start([](Progress& progress) {
        progress.enter(3);
        return 42;
    });
    EXPECT_EQ(wait(task), 42);
    while (announcements == 0)
        std::this_thread::yield();
    EXPECT_EQ(announcements, 1);
    EXPECT_FALSE(task.isRunning());
    EXPECT_EQ(task.take(), std::nullopt);
}

// A window that was woken looks once and sleeps again.
TEST(BackgroundTask, IsEndedWhenItIsAnnounced)
{
    static BackgroundTask<int>* announced = nullptr;
    static std::atomic<int> ended = 0, announcement = 0;
    BackgroundTask<int> task([] {
        ended += announced->isEnded();
        ++announcement;
    });
    announced = &task;
    ended = announcement = 0;
    task.start([](Progress&) { return 1; });
    while (announcement < 1)
        std::this_thread::yield();
    EXPECT_EQ(ended, 1);
    task.start([](Progress&) -> int { throw std::runtime_error("broken"); });
    while (announcement < 2)
        std::this_thread::yield();
    EXPECT_EQ(ended, 2) << "of work that failed, too";
}

TEST(BackgroundTask, StopsAtTheNextPartWhereItIsCancelled)
{
    BackgroundTask<int> task(announce);
    std::atomic<bool> passed = false, begun = false, go = false;
    task.start([&](Progress& progress) {
        begun = true;
        while (!go)
            std::this_thread::yield();
        progress.enter(1);
        passed = true;
        return 1;
    });
    while (!begun)
        std::this_thread::yield();
    task.cancel();
    go = true;
    EXPECT_EQ(wait(task), std::nullopt);
    EXPECT_FALSE(passed);
}

TEST(BackgroundTask, APartHearsOfItWhereItLooks)
{
    BackgroundTask<int> task(announce);
    std::atomic<int> pieces = 0;
    task.start([&](Progress& progress) {
        for (const std::stop_token stop = progress.stopToken();; ++pieces)
            endWhereStopped(stop); // as a loader does before each image
        return 1;
    });
    while (pieces == 0)
        std::this_thread::yield();
    task.cancel();
    EXPECT_EQ(wait(task), std::nullopt);
}

TEST(BackgroundTask, IsWaitedFor)
{
    BackgroundTask<int> task(announce);
    task.wait(); // for nothing
    EXPECT_FALSE(task.isEnded());
    std::atomic<bool> go = false;
    task.start([&](Progress&) {
        while (!go)
            std::this_thread::yield();
        return 7;
    });
    EXPECT_FALSE(task.isEnded());
    go = true;
    task.wait();
    EXPECT_TRUE(task.isEnded());
    EXPECT_EQ(task.take(), 7);
    EXPECT_FALSE(task.isEnded());
}

TEST(BackgroundTask, AResultThatCameTooLateIsDropped)
{
    BackgroundTask<int> task(announce);
    std::atomic<bool> go = false;
    task.start([&](Progress&) {
        while (!go)
            std::this_thread::yield();
        return 1;
    });
    task.cancel();
    go = true;
    EXPECT_EQ(wait(task), std::nullopt);
}

TEST(BackgroundTask, RethrowsWhatWentWrong)
{
    BackgroundTask<int> task(announce);
    task.start([](Progress&) -> int { throw std::runtime_error("broken"); });
    EXPECT_THROW(wait(task), std::runtime_error);
    EXPECT_FALSE(task.isRunning());
}

} // namespace
} // namespace torrance
