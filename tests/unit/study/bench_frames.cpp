#include "study/bench_frames.h"

#include "math/number_stream.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

namespace torrance {
namespace {

std::function<TimeUse()> always(double processor, double wall = 1.0)
{
    return [=] { return TimeUse{.processor = processor, .wall = wall}; };
}

std::vector<FrameTimes> timed(const std::vector<std::function<TimeUse()>>& items, const BenchBounds& bounds,
                              BenchClock clock = BenchClock::processor)
{
    return timeFrames(items, bounds, clock);
}

TEST(TimeFrames, EndsAtTheNumberOfFrames)
{
    NumberStream numbers(1);
    const auto noisy = [&] { return TimeUse{.processor = 1.0 + numbers.next(), .wall = 1.0}; };
    const std::vector<FrameTimes> times = timed({noisy, always(2.0)}, {.frames = 5});
    ASSERT_EQ(times.size(), 2u);
    EXPECT_EQ(times[0].processor.size(), 5u);
    EXPECT_EQ(times[1].processor, std::vector<double>(5, 2.0));
    EXPECT_EQ(times[1].wall, std::vector<double>(5, 1.0));
}

TEST(TimeFrames, EndsWithTheRoundInWhichTheTimeIsOver)
{
    const std::vector<FrameTimes> times = timed({always(1.0), always(1.0)}, {.seconds = 0.0});
    EXPECT_EQ(times[0].wall.size(), 1u) << "one of each is always drawn";
    EXPECT_EQ(times[1].wall.size(), 1u);
}

TEST(TimeFrames, EndsWhenAllAreKnownByTheClockThatDecides)
{
    EXPECT_EQ(timed({always(1.0), always(2.0)}, {})[0].wall.size(), std::size_t(kLeastFrames));
    // Alternately 1 and 2: no interval is narrower than that.
    int frame = 0;
    const auto alternating = [&] { return TimeUse{.processor = 1.0 + (frame++ % 2), .wall = 1.0}; };
    const BenchBounds bounds = {.frames = 300};
    EXPECT_EQ(timed({always(1.0), alternating}, bounds)[0].wall.size(), 300u) << "the other is not known";
    EXPECT_EQ(timed({alternating}, bounds, BenchClock::wall)[0].wall.size(), std::size_t(kLeastFrames));
}

TEST(TimeFrames, BeginsEachRoundWithAnother)
{
    std::string order;
    std::vector<std::function<TimeUse()>> items;
    for (const char name : {'a', 'b', 'c'})
        items.emplace_back([&order, name] {
            order += name;
            return TimeUse{.processor = 1.0, .wall = 1.0};
        });
    timed(items, {.frames = 4});
    EXPECT_EQ(order, "abcbcacababc");
}

// Frames of 1 s and up to a tenth more, evenly distributed: median 1.05. What is stopped when its interval is narrow is
// stopped early where the interval happens to be; it must still hold the median nearly as often as it says. 95 % of
// 2000 are 1900 +- 10; nine in ten is what we grant.
TEST(TimeFrames, StopsWithIntervalsThatHoldTheMedian)
{
    NumberStream numbers(11);
    const auto noisy = [&] { return TimeUse{.processor = 1.0 + 0.1 * numbers.next(), .wall = 1.0}; };
    int held = 0;
    constexpr int kTrials = 2000;
    for (int trial = 0; trial < kTrials; ++trial) {
        const std::vector<FrameTimes> times = timed({noisy}, {});
        const Estimate estimate = estimateMedian(times[0].processor);
        ASSERT_LE(estimate.relativeWidth(), 0.02);
        held += estimate.low <= 1.05 && 1.05 <= estimate.high;
    }
    EXPECT_GE(held, 9 * kTrials / 10);
}

} // namespace
} // namespace torrance
