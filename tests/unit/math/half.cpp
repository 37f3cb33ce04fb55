#include "math/half.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

/// IEEE 754 section 3.4, from the fields: an independent way back.
double valueOf(std::uint16_t half)
{
    const double sign = (half & 0x8000) != 0 ? -1.0 : 1.0;
    const int exponent = (half >> 10) & 31;
    const int fraction = half & 1023;
    if (exponent == 31)
        return fraction == 0 ? sign * std::numeric_limits<double>::infinity()
                             : std::numeric_limits<double>::quiet_NaN();
    return sign * (exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25));
}

TEST(Half, EveryHalfComesBack)
{
    for (std::uint32_t h = 0; h < 65536; ++h) {
        const double value = valueOf(static_cast<std::uint16_t>(h));
        if (!std::isnan(value)) {
            ASSERT_EQ(toHalf(static_cast<float>(value)), h);
        }
    }
    EXPECT_TRUE(std::isnan(valueOf(toHalf(std::numeric_limits<float>::quiet_NaN()))));
}

TEST(Half, RoundsToTheNearestAndTiesToEven)
{
    for (std::uint32_t h = 0; h < 0x7bff; ++h) {
        const double low = valueOf(static_cast<std::uint16_t>(h));
        const double high = valueOf(static_cast<std::uint16_t>(h + 1));
        const auto middle = static_cast<float>(0.5 * (low + high)); // exact in float
        ASSERT_EQ(toHalf(middle), h % 2 == 0 ? h : h + 1) << "a tie";
        ASSERT_EQ(toHalf(std::nextafter(middle, 0.0f)), h);
        ASSERT_EQ(toHalf(std::nextafter(middle, 1e6f)), h + 1);
    }
    EXPECT_EQ(toHalf(65519.0f), 0x7bff);
    EXPECT_EQ(toHalf(65520.0f), 0x7c00) << "infinity";
    EXPECT_EQ(toHalf(-1e30f), 0xfc00);
}

} // namespace
} // namespace torrance
