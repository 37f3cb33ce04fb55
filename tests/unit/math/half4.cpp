#include "math/half4.h"

#include "math/half.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

void expectHalves(float value)
{
    const Int4 four = halfBits(Float4{value, 0.0f, 1.0f, 0.5f});
    ASSERT_EQ(four[0], toHalf(value)) << value;
    ASSERT_EQ(four[1], 0);
    ASSERT_EQ(four[2], 0x3c00);
    ASSERT_EQ(four[3], 0x3800);
}

TEST(Half4, EachLaneIsTheNearestHalf)
{
    // Beside every half of [0, 1] and beside every tie between two, and some between.
    for (int half = 0; half < 0x3c00; ++half) {
        const float low =
            half < 0x400 ? std::ldexp(float(half), -24) : std::ldexp(float(1024 + (half & 0x3ff)), (half >> 10) - 25);
        const float step = half < 0x400 ? std::ldexp(1.0f, -24) : std::ldexp(1.0f, (half >> 10) - 25);
        for (const float share : {0.0f, 0.25f, 0.5f, 0.75f}) {
            const auto bits = std::bit_cast<std::uint32_t>(low + share * step);
            for (const std::uint32_t beside : {bits, bits + 1, bits == 0 ? 0 : bits - 1})
                expectHalves(std::bit_cast<float>(beside));
        }
    }
    expectHalves(1.0f);
}

} // namespace
} // namespace torrance
