#include "measure/quantile_ranks.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

TEST(QuantileRanks, AreThoseOfTheBinomialForASmallShareOfThePopulation)
{
    // Sign test, n = 20, 2.5 % each: the 6th value from either end (Conover, Practical Nonparametric Statistics, 3rd
    // edition, table A3: P(B(20, 1/2) <= 5) = 0.0207, P(<= 6) = 0.0577).
    const QuantileRanks median = quantileRanks(10'000'000, 20, 0.5);
    EXPECT_EQ(median.low, 6u);
    EXPECT_EQ(median.high, 15u);
    // 0.99^368 = 0.0248 <= 0.025 < 0.99^367: from 368 values on the greatest bounds the 99th percentile.
    EXPECT_FALSE(quantileRanks(10'000'000, 367, 0.99).high);
    EXPECT_EQ(quantileRanks(10'000'000, 368, 0.99).high, 368u);
}

TEST(QuantileRanks, AreTheQuantileItselfWhereAllWereDrawn)
{
    for (const double rank : {0.5, 0.99}) {
        const QuantileRanks ranks = quantileRanks(300, 300, rank);
        EXPECT_EQ(ranks.low, nearestRank(300, rank));
        EXPECT_EQ(ranks.high, nearestRank(300, rank));
    }
    EXPECT_EQ(nearestRank(100, 0.99), 99u);
    EXPECT_EQ(nearestRank(101, 0.99), 100u);
    EXPECT_EQ(nearestRank(1, 0.5), 1u);
}

// By counting every sample of 3 out of 6: the median, value 3 of 1..6, lies below the least of a sample where that is
// drawn from {4, 5, 6}: 1 of 20; so the least bounds it with 0.95 only, and not with 0.975.
TEST(QuantileRanks, CountWithoutReplacement)
{
    EXPECT_FALSE(quantileRanks(6, 3, 0.5).low);
    // Out of 4, sample of 3, median 2: the least is above it in none of 4 samples.
    EXPECT_EQ(quantileRanks(4, 3, 0.5).low, 1u);
}

} // namespace
} // namespace torrance
