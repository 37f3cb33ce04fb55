#include "study/material_errors.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

// Two strata of unlike weight: a pixel of the first stands for 2, one of the second for 6.
TEST(MaterialErrors, AreWeighedAsTheirStrata)
{
    const std::vector<PixelStratum> strata = {{4, {0, 1}}, {12, {4, 5}}};
    const std::vector<CoveredPixel> sample = {{.material = 0}, {.material = -1}, {.material = 0}, {.material = 2}};
    const auto known = [](double error, double norm) {
        return PixelError{.above = error, .below = error, .norm = norm};
    };
    const std::vector<PixelError> errors = {known(0.1, 1.0), known(0.2, 2.0), known(0.3, 0.5), known(0.0, 1.0)};
    const MaterialErrors all = materialErrors(strata, sample, errors, 3);
    constexpr double kNorm = 2 * 1.0 + 2 * 2.0 + 6 * 0.5 + 6 * 1.0, kPixels = 16;
    ASSERT_EQ(all.size(), 3u);
    EXPECT_DOUBLE_EQ(all.at(0).error, (2 * 0.1 + 6 * 0.3) / kNorm);
    EXPECT_DOUBLE_EQ(all.at(0).pixels, 8 / kPixels);
    EXPECT_DOUBLE_EQ(all.at(3).error, 2 * 0.2 / kNorm) << "the default material's number is behind the last";
    EXPECT_DOUBLE_EQ(all.at(3).pixels, 2 / kPixels);
    EXPECT_DOUBLE_EQ(all.at(2).error, 0.0);
    EXPECT_DOUBLE_EQ(all.at(2).pixels, 6 / kPixels);
}

} // namespace
} // namespace torrance
