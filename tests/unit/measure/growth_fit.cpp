#include "measure/growth_fit.h"

#include "math/number_stream.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

const std::vector<double> kSizes = {1.0, 4.0, 16.0, 64.0, 256.0};

std::vector<double> costsOf(const std::function<double(double)>& cost)
{
    std::vector<double> costs;
    for (const double size : kSizes)
        costs.push_back(cost(size));
    return costs;
}

// Each cost is off by a factor of up to 1 +- noise.
std::vector<std::vector<double>> roundsOf(const std::function<double(double)>& cost, double noise)
{
    NumberStream numbers(3);
    std::vector<std::vector<double>> rounds;
    for (int round = 0; round < 9; ++round)
        rounds.push_back(costsOf([&](double n) { return cost(n) * (1.0 + noise * (2.0 * numbers.next() - 1.0)); }));
    return rounds;
}

GrowthKind kindOf(const std::function<double(double)>& cost, double noise = 0.01)
{
    return fitGrowth(kSizes, roundsOf(cost, noise)).kind;
}

TEST(FitLine, FindsALine)
{
    const Line line = fitLine(kSizes, costsOf([](double n) { return 5.0 + 0.25 * n; }));
    EXPECT_NEAR(line.slope, 0.25, 1e-15);
    EXPECT_NEAR(line.constant, 5.0, 1e-14);
}

// Of five points the one in the middle may be anywhere: the weights of its pairs, 15 + 12 + 48 + 240, are less than
// half of all, 3 + 15 + 63 + 255 + 12 + 60 + 252 + 48 + 240 + 192 = 1140.
TEST(FitLine, IsNotMovedByOnePointThatIsFarOff)
{
    for (const double wrong : {-1e6, 1e6}) {
        std::vector<double> costs = costsOf([](double n) { return 5.0 + 0.25 * n; });
        costs[2] = wrong;
        const Line line = fitLine(kSizes, costs);
        EXPECT_NEAR(line.slope, 0.25, 1e-12);
        EXPECT_NEAR(line.constant, 5.0, 1e-12);
    }
}

// Five small sizes whose costs rise by 1 from one to the next for reasons of their own, and one far away: the slopes to
// it are 0.01 less up to 4/995, those among the five, twice as many, all 1.01. Weights: 4985 and 20.
TEST(FitLine, ListensToWhatLiesFarApart)
{
    const std::vector<double> sizes = {1.0, 2.0, 3.0, 4.0, 5.0, 1000.0};
    std::vector<double> costs;
    for (const double size : sizes)
        costs.push_back(10.0 + 0.01 * size + (size < 10.0 ? size - 1.0 : 0.0));
    const Line line = fitLine(sizes, costs);
    EXPECT_LE(line.slope, 0.01);
    EXPECT_GE(line.slope, 0.01 - 4.0 / 995.0 - 1e-12);
}

TEST(GrowthExponent, IsThatOfAPowerAboveAnyConstant)
{
    for (const double p : {0.5, 1.0, 1.5, 2.0})
        for (const double constant : {0.0, 7.0, 1e4}) {
            const auto cost = [&](double n) { return constant + 3.0 * std::pow(n, p); };
            EXPECT_NEAR(growthExponent(cost(5.0), cost(20.0), cost(80.0), 4.0), p, 1e-9);
            EXPECT_NEAR(growthExponent(cost(5.0), cost(50.0), cost(500.0), 10.0), p, 1e-9);
        }
    // n + q n^2 with q = 0.3 / N at n = N, N/4, N/16: log_4 of 4 (1 + 0.3 * 5/4) / (1 + 0.3 * 5/16).
    const auto square = [](double n) { return n + 0.3 * n * n; };
    EXPECT_NEAR(growthExponent(square(1.0 / 16), square(0.25), square(1.0), 4.0),
                1.0 + std::log(1.375 / 1.09375) / std::log(4.0), 1e-12);
    EXPECT_EQ(growthExponent(1.0, 2.0, 2.0, 4.0), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(growthExponent(1.0, 1.0, 2.0, 4.0), std::numeric_limits<double>::infinity());
}

TEST(FitGrowth, TellsWhatGrowsHow)
{
    EXPECT_EQ(kindOf([](double) { return 10.0; }), GrowthKind::none);
    EXPECT_EQ(kindOf([](double n) { return 10.0 + 0.0005 * n; }, 0.0), GrowthKind::none) << "1.3 % is not worth a word";
    EXPECT_EQ(kindOf([](double n) { return 10.0 + n; }), GrowthKind::linear);
    EXPECT_EQ(kindOf([](double n) { return 10.0 + std::sqrt(n); }), GrowthKind::linear) << "at most";
    EXPECT_EQ(kindOf([](double n) { return 10.0 + n * n; }), GrowthKind::superLinear);
    EXPECT_EQ(kindOf([](double n) { return 10.0 + n + n * n / 256.0; }), GrowthKind::superLinear);
    EXPECT_EQ(kindOf([](double n) { return 10.0 + n; }, 0.3), GrowthKind::undecided) << "too noisy";
    EXPECT_EQ(fitGrowth(kSizes, roundsOf([](double n) { return n; }, 0.0)).slope.median, 1.0);
}

TEST(FitGrowth, DecidesNothingFromOneRound)
{
    const std::vector<std::vector<double>> round = {costsOf([](double n) { return n * n; })};
    const GrowthFit fit = fitGrowth(kSizes, round);
    EXPECT_EQ(fit.kind, GrowthKind::undecided);
    EXPECT_NEAR(fit.exponent.median, 2.0, 1e-12);
}

// The line of each round is exact, and slower by what the round suffers: the median is that of nine factors 0.96 ...
// 1.04, the interval from the second to the eighth.
TEST(FitGrowth, HasTheIntervalOfTheRounds)
{
    std::vector<std::vector<double>> rounds;
    for (int i = 0; i < 9; ++i)
        rounds.push_back(costsOf([&](double n) { return (0.96 + 0.01 * i) * (100.0 + 2.0 * n); }));
    const GrowthFit fit = fitGrowth(kSizes, rounds);
    EXPECT_NEAR(fit.slope.median, 2.0, 1e-9);
    EXPECT_NEAR(fit.slope.low, 1.94, 1e-9);
    EXPECT_NEAR(fit.slope.high, 2.06, 1e-9);
    EXPECT_NEAR(fit.constant.median, 100.0, 1e-9);
    EXPECT_NEAR(fit.exponent.low, 1.0, 1e-9);
    EXPECT_NEAR(fit.exponent.high, 1.0, 1e-9);
}

} // namespace
} // namespace torrance
