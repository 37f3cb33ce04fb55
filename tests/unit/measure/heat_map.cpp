#include "measure/heat_map.h"

#include "image/srgb.h"

#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

TEST(HeatMap, RisesEvenlyInLightness)
{
    Image error(101, 1, 1);
    for (int x = 0; x <= 100; ++x)
        *error.at(x, 0) = static_cast<float>(x) / 100.0f;
    const Image colors = heatMap(error);
    const auto luminance = [&](int x) {
        const float* c = colors.at(x, 0);
        return 0.2126f * srgbDecode(c[0]) + 0.7152f * srgbDecode(c[1]) + 0.0722f * srgbDecode(c[2]);
    };
    for (int x = 1; x <= 100; ++x)
        EXPECT_GT(luminance(x), luminance(x - 1)) << x;
    // The ends of matplotlib's magma: (0.001462, 0.000466, 0.013866) and (0.987053, 0.991438, 0.749504), within half a
    // code.
    EXPECT_NEAR(colors.at(0, 0)[2], 0.013866, 0.5 / 255);
    EXPECT_NEAR(colors.at(100, 0)[1], 0.991438, 0.5 / 255);
    EXPECT_NEAR(colors.at(50, 0)[0], 0.716387, 0.02) << "the middle";
}

TEST(HeatMap, ClipsAndShowsNanAsTheWorst)
{
    Image error(3, 1, 1);
    error.texels = {-1.0f, 2.0f, std::numeric_limits<float>::quiet_NaN()};
    const Image colors = heatMap(error);
    EXPECT_EQ(colors.at(0, 0)[0], 0.0f);
    EXPECT_EQ(colors.at(1, 0)[0], colors.at(2, 0)[0]);
}

} // namespace
} // namespace torrance
