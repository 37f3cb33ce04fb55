#include "image/linear_scale.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

TEST(LinearScale, OffsetGoesWithCoverage)
{
    Image image(2, 1, 4);
    image.texels = {-1.0f, 0.5f, 1.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f}; // a half vector, and nothing
    const Image shown = scaled(image, 0.5, 0.5);
    EXPECT_EQ(shown.texels, (std::vector<float>{0.0f, 0.75f, 1.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f}));
}

TEST(LinearScale, GreatestValueIsOfColoursAndFinite)
{
    Image image(2, 1, 4);
    image.texels = {0.5f, 3.0f, INFINITY, 9.0f, NAN, -7.0f, 1.0f, 9.0f};
    EXPECT_EQ(greatestValue(image), 3.0);
    EXPECT_EQ(greatestValue(Image(1, 1, 4)), 0.0);
}

} // namespace
} // namespace torrance
