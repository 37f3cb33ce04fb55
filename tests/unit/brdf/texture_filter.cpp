// Levels of detail of footprints whose answer is known.
#include "brdf/texture_filter.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

TEST(TextureFilter, LevelsAreLogarithmsOfTheLongerStep)
{
    for (const auto& formula : {T_trilinear, T_trilinear_exact, T_trilinear_words}) {
        EXPECT_DOUBLE_EQ(formula({dvec2(1, 0), dvec2(0, 0.5)}), 0.0) << "a texel a pixel is the texture as it is";
        EXPECT_DOUBLE_EQ(formula({dvec2(3, 4), dvec2(0, 1)}), std::log2(5.0));
        EXPECT_DOUBLE_EQ(formula({dvec2(0.25, 0), dvec2(-6, 8)}), std::log2(10.0)) << "whichever axis is the longer";
        EXPECT_EQ(formula({dvec2(0), dvec2(0)}), -HUGE_VAL);
    }
}

TEST(TextureFilter, TheNearestLevelIsWhole)
{
    const auto level = [](double texels) { return T_nearest_level({dvec2(texels, 0), dvec2(0)}); };
    EXPECT_EQ(level(8.0), 3.0);
    EXPECT_EQ(level(std::exp2(2.49)), 2.0);
    EXPECT_EQ(level(std::exp2(2.51)), 3.0);
    EXPECT_EQ(level(0.1), -3.0);
}

} // namespace
} // namespace torrance::brdf
