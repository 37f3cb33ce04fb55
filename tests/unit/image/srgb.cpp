#include "image/srgb.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

TEST(Srgb, HasTheStandardsValues)
{
    // IEC 61966-2-1: the linear segment's slope, and the power segment at one half in exact arithmetic,
    // 1.055 * 0.5^(1/2.4) - 0.055 and ((0.5 + 0.055) / 1.055)^2.4.
    EXPECT_DOUBLE_EQ(srgbEncode(0.001), 0.01292);
    EXPECT_NEAR(srgbEncode(0.5), 0.7353569830524495, 1e-15);
    EXPECT_NEAR(srgbDecode(0.5), 0.21404114048223255, 1e-15);
    EXPECT_DOUBLE_EQ(srgbEncode(1.0), 1.0);
}

TEST(Srgb, EncodingUndoesDecoding)
{
    // The standard rounds its limits to five digits, so that next to them the two directions may take different
    // segments, which lie up to 3e-8 apart there.
    for (int code = 0; code <= 65535; ++code) {
        const double value = code / 65535.0;
        const double allowed = std::abs(value - 0.04045) < 1e-5 ? 3e-8 : 1e-14;
        EXPECT_NEAR(srgbEncode(srgbDecode(value)), value, allowed) << code;
        EXPECT_NEAR(srgbEncode(srgbDecode(static_cast<float>(value))), value, 5e-7) << code;
    }
}

TEST(Srgb, IsNotThePowerOfTwoPointTwo)
{
    EXPECT_GT(std::abs(srgbEncode(0.01) - std::pow(0.01, 1 / 2.2)), 0.02);
}

TEST(Srgb, DefinesWhatNoLightIs)
{
    EXPECT_EQ(srgbEncode(std::numeric_limits<double>::quiet_NaN()), 0.0);
    EXPECT_EQ(srgbEncode(-0.5f), 0.0f);
    EXPECT_EQ(srgbDecode(-0.5f), 0.0f);
    EXPECT_GT(srgbEncode(4.0), 1.0) << "clipping is the quantiser's";
}

} // namespace
} // namespace torrance
