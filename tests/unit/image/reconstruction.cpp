#include "image/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

TEST(Reconstruction, TheFilterIntegratesToOneAndIsEven)
{
    EXPECT_NEAR(filterCumulative(-kFilterRadius), 0.0, 1e-15);
    EXPECT_NEAR(filterCumulative(kFilterRadius), 1.0, 1e-15);
    for (double x = 0.0; x < kFilterRadius; x += 0.05)
        EXPECT_NEAR(filterCumulative(x) + filterCumulative(-x), 1.0, 1e-15);
}

TEST(Reconstruction, TheCumulativeIsTheIntegralOfTheWindow)
{
    // Midpoint rule over Harris' window itself.
    const auto window = [](double x) {
        const double t = kPi * x / kFilterRadius;
        return (0.35875 + 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) + 0.01168 * std::cos(3 * t)) /
               (2.0 * kFilterRadius * 0.35875);
    };
    constexpr int kSteps = 20000;
    double sum = 0.0;
    const double step = 1.3 * kFilterRadius / kSteps;
    for (int i = 0; i < kSteps; ++i)
        sum += window(-kFilterRadius + (i + 0.5) * step) * step;
    EXPECT_NEAR(filterCumulative(0.3 * kFilterRadius), sum, 1e-8);
}

TEST(Reconstruction, OneSampleIsThePixelsCentre)
{
    EXPECT_EQ(sampleOffsets(1).front(), dvec2(0.0));
}

TEST(Reconstruction, SamplesAreBalancedAndEachHasARowAndAColumn)
{
    for (const int count : {4, 16, 64}) {
        const auto offsets = sampleOffsets(count);
        ASSERT_EQ(offsets.size(), static_cast<std::size_t>(count));
        dvec2 mean(0.0);
        std::vector<bool> columns(offsets.size()), rows(offsets.size());
        for (const dvec2& offset : offsets) {
            mean += offset / double(count);
            columns[static_cast<std::size_t>(filterCumulative(offset.x) * count)] = true;
            rows[static_cast<std::size_t>(filterCumulative(offset.y) * count)] = true;
        }
        EXPECT_NEAR(glm::length(mean), 0.0, 1e-12) << count;
        EXPECT_EQ(std::count(columns.begin(), columns.end(), true), count);
        EXPECT_EQ(std::count(rows.begin(), rows.end(), true), count);
    }
}

} // namespace
} // namespace torrance
