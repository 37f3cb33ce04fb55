#include "measure/ratio_estimate.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

RatioUnit unit(double numerator, double denominator)
{
    return {.numerator = numerator, .denominator = denominator};
}

TEST(RatioEstimate, OfTheWholePopulationHasNoErrorButItsNoise)
{
    RatioStratum all = {.population = 3, .units = {unit(1, 10), unit(2, 10), unit(6, 10)}};
    RatioEstimate estimate = estimateRatio(std::span(&all, 1));
    EXPECT_DOUBLE_EQ(estimate.ratio, 0.3);
    EXPECT_EQ(estimate.standardError, 0.0);
    all.units[0].numeratorVariance = 9.0;
    estimate = estimateRatio(std::span(&all, 1));
    EXPECT_DOUBLE_EQ(estimate.standardError, 3.0 / 30.0);
    EXPECT_DOUBLE_EQ(estimate.degrees, kNoiseDegrees);
}

TEST(RatioEstimate, CountsStrataByTheirSizeAndWhatWasNotDrawn)
{
    // Cochran's eq. 6.48 and 6.51 by hand: R = (10 * 2 + 30 * 4) / (10 * 10 + 30 * 10) = 0.35; residuals +-1 and 0
    // about their means; s^2 = 2 in the first; variance 100 * 0.8 * 2 / 2 = 80; over 400^2.
    const RatioStratum strata[] = {{.population = 10, .units = {unit(1, 10), unit(3, 10)}},
                                   {.population = 30, .units = {unit(4, 10), unit(4, 10)}}};
    const RatioEstimate estimate = estimateRatio(strata);
    EXPECT_DOUBLE_EQ(estimate.ratio, 0.35);
    EXPECT_NEAR(estimate.standardError, std::sqrt(80.0) / 400.0, 1e-15);
    EXPECT_DOUBLE_EQ(estimate.degrees, 1.0) << "one stratum of two units carries all of it";
}

TEST(RatioEstimate, NothingOverNothingIsNothing)
{
    const RatioStratum black = {.population = 5, .units = {unit(0, 0), unit(0, 0)}};
    EXPECT_EQ(estimateRatio(std::span(&black, 1)).ratio, 0.0);
    const RatioStratum lit = {.population = 5, .units = {unit(1, 0), unit(0, 0)}};
    EXPECT_FALSE(std::isfinite(estimateRatio(std::span(&lit, 1)).ratio));
}

} // namespace
} // namespace torrance
