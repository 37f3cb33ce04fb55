#include "measure/timing_statistics.h"

#include "math/number_stream.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <vector>

namespace torrance {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<double> upTo(int n)
{
    std::vector<double> values(static_cast<std::size_t>(n));
    std::iota(values.rbegin(), values.rend(), 1.0); // n, ..., 2, 1
    return values;
}

TEST(Median, IsTheMiddleOrBetweenTheTwo)
{
    EXPECT_EQ(median(std::vector{3.0}), 3.0);
    EXPECT_EQ(median(std::vector{9.0, 1.0, 4.0}), 4.0);
    EXPECT_EQ(median(std::vector{9.0, 1.0, 4.0, 2.0}), 3.0);
    EXPECT_EQ(median(std::vector{1.0, kInfinity, kInfinity, kInfinity}), kInfinity);
}

// By Pascal's triangle: P(at most k - 1 of n below the median) = (C(n, 0) + ... + C(n, k - 1)) / 2^n must not exceed
// 1/40. n = 5: 1/32; 6: 1/64; 8: 1/256, 9/256; 9: 10/512, 46/512; 12: 79/4096, 299/4096; 20: 21700/2^20, 60460/2^20.
// n = 100: Conover, Practical Nonparametric Statistics: ranks 40 and 61.
TEST(MedianRank, IsTheBinomialDistributions)
{
    EXPECT_EQ(medianRank(1, 0.95), 0u);
    EXPECT_EQ(medianRank(5, 0.95), 0u);
    EXPECT_EQ(medianRank(6, 0.95), 1u);
    EXPECT_EQ(medianRank(8, 0.95), 1u);
    EXPECT_EQ(medianRank(9, 0.95), 2u);
    EXPECT_EQ(medianRank(12, 0.95), 3u);
    EXPECT_EQ(medianRank(20, 0.95), 6u);
    EXPECT_EQ(medianRank(100, 0.95), 40u);
    EXPECT_EQ(medianRank(8, 0.99), 1u);
    EXPECT_EQ(medianRank(7, 0.99), 0u);
    EXPECT_EQ(medianRank(2, 0.5), 1u); // 1 - 2/4 is the half asked for
}

// The normal approximation: n/2 - 1.96 sqrt(n)/2, good to one rank; 2^-20000 underflows.
TEST(MedianRank, IsRightForManyValues)
{
    const auto expected = 10000.0 - 1.95996 * std::sqrt(20000.0) / 2.0;
    EXPECT_NEAR(static_cast<double>(medianRank(20000, 0.95)), expected, 1.0);
}

TEST(EstimateMedian, TakesTheRanksFromBothEnds)
{
    const Estimate nine = estimateMedian(upTo(9));
    EXPECT_EQ(nine.median, 5.0);
    EXPECT_EQ(nine.low, 2.0);
    EXPECT_EQ(nine.high, 8.0);
    EXPECT_EQ(nine.count, 9u);
    EXPECT_EQ(nine.relativeWidth(), 6.0 / 5.0);
    const Estimate hundred = estimateMedian(upTo(100));
    EXPECT_EQ(hundred.low, 40.0);
    EXPECT_EQ(hundred.high, 61.0);
    const Estimate five = estimateMedian(upTo(5));
    EXPECT_EQ(five.low, -kInfinity);
    EXPECT_EQ(five.high, kInfinity);
}

// Skewed noise, as of times: 1 plus an exponential distribution, whose median is 1 + ln 2. Of n = 20 values the
// interval of ranks 6 and 15 holds it with the probability 1 - 2 * 21700 / 2^20 = 0.95861.
TEST(EstimateMedian, HoldsTheTruthAsOftenAsItSays)
{
    constexpr int kTrials = 20000;
    constexpr double kProbability = 1.0 - 2.0 * 21700.0 / 1048576.0;
    NumberStream numbers(7);
    int held = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<double> values;
        for (int i = 0; i < 20; ++i)
            values.push_back(1.0 - std::log(1.0 - numbers.next()));
        const Estimate estimate = estimateMedian(values);
        held += estimate.low <= 1.0 + std::log(2.0) && 1.0 + std::log(2.0) <= estimate.high;
    }
    const double deviation = std::sqrt(kProbability * (1.0 - kProbability) * kTrials);
    EXPECT_NEAR(held, kProbability * kTrials, 4.0 * deviation);
}

// A machine that becomes three times slower half way through disturbs both alike: the ratio does not see it.
TEST(EstimatePairedRatio, IsBlindToWhatBothSuffer)
{
    std::vector<double> base, other;
    for (int i = 0; i < 40; ++i) {
        base.push_back((i < 20 ? 1.0 : 3.0) * (1.0 + 0.001 * (i % 7)));
        other.push_back(1.25 * (i < 20 ? 1.0 : 3.0) * (1.0 + 0.001 * (i % 5)));
    }
    const Estimate ratio = estimatePairedRatio(base, other);
    EXPECT_NEAR(ratio.median, 1.25, 0.006 * 1.25);
    EXPECT_LT(ratio.high - ratio.low, 0.012 * 1.25);
    EXPECT_GT(estimateMedian(base).relativeWidth(), 0.9) << "the times themselves are all over the place";
}

TEST(RatioOf, AllowsForBothIntervals)
{
    const Estimate base = {.median = 10.0, .low = 8.0, .high = 12.0, .count = 30};
    const Estimate other = {.median = 15.0, .low = 12.0, .high = 16.0, .count = 20};
    const Estimate ratio = ratioOf(base, other);
    EXPECT_EQ(ratio.median, 1.5);
    EXPECT_EQ(ratio.low, 1.0);
    EXPECT_EQ(ratio.high, 2.0);
    EXPECT_EQ(ratio.count, 20u);
    const Estimate unknown = {.median = 10.0, .low = -kInfinity, .high = kInfinity, .count = 3};
    EXPECT_EQ(ratioOf(unknown, other).high, kInfinity);
    EXPECT_EQ(ratioOf(base, unknown).low, -kInfinity);
}

} // namespace
} // namespace torrance
