#include "math/float4.h"

#include <algorithm>
#include <bit>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

void expectSameBits(float a, float b)
{
    EXPECT_EQ(std::bit_cast<std::uint32_t>(a), std::bit_cast<std::uint32_t>(b)) << a << " and " << b;
}

TEST(Float4, ComparesAsTheStandardLibraryDoes)
{
    const float values[] = {0.0f, -0.0f, 1.0f, -2.5f, kNaN, std::numeric_limits<float>::infinity()};
    for (const float a : values)
        for (const float b : values) {
            expectSameBits(least(splat(a), splat(b))[2], std::min(a, b));
            expectSameBits(greatest(splat(a), splat(b))[2], std::max(a, b));
        }
}

TEST(Float4, TakesRootsLaneByLane)
{
    const Float4 root = squareRoot(Float4{4.0f, 2.0f, 0.0f, 1e-40f});
    expectSameBits(root[0], 2.0f);
    expectSameBits(root[1], std::sqrt(2.0f));
    expectSameBits(root[2], 0.0f);
    expectSameBits(root[3], std::sqrt(1e-40f));
}

TEST(Float4, RoundsProductsHalfToEvenFromDouble)
{
    // A quarter and three quarters of 2 are halves. Between two codes of 255, the floats on either side of the half: a
    // product in float would not always tell them apart.
    const Int4 halves = roundedProduct(Float4{0.5f, 0.25f, 0.75f, 1.0f}, 2.0);
    EXPECT_EQ(halves[0], 1);
    EXPECT_EQ(halves[1], 0);
    EXPECT_EQ(halves[2], 2);
    EXPECT_EQ(halves[3], 2);
    for (int code = 0; code < 255; ++code) {
        auto below = static_cast<float>((code + 0.5) / 255.0);
        while (static_cast<double>(below) * 255.0 >= code + 0.5)
            below = std::nextafter(below, 0.0f);
        EXPECT_EQ(roundedProduct(splat(below), 255.0)[1], code);
        EXPECT_EQ(roundedProduct(splat(std::nextafter(below, 1.0f)), 255.0)[3], code + 1);
    }
}

TEST(Float4, Transposes)
{
    Float4 a = {0, 1, 2, 3}, b = {10, 11, 12, 13}, c = {20, 21, 22, 23}, d = {30, 31, 32, 33};
    transpose(a, b, c, d);
    const Float4* rows[] = {&a, &b, &c, &d};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            EXPECT_EQ((*rows[i])[j], static_cast<float>(10 * j + i));
}

TEST(Float4, PacksWholeRanges)
{
    const Int4 a = {0, 1, 254, 255}, b = {127, 128, 129, 130}, c = {5, 6, 7, 8}, d = {9, 10, 11, 12};
    std::uint8_t narrow[16];
    pack(a, b, c, d, narrow);
    const Int4 e = {0, 1, 32767, 32768}, f = {65535, 65534, 32769, 40000};
    std::uint16_t wide[16];
    pack(e, f, c, d, wide);
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(narrow[i], a[i]);
        EXPECT_EQ(narrow[4 + i], b[i]);
        EXPECT_EQ(narrow[8 + i], c[i]);
        EXPECT_EQ(narrow[12 + i], d[i]);
        EXPECT_EQ(wide[i], e[i]);
        EXPECT_EQ(wide[4 + i], f[i]);
        EXPECT_EQ(wide[8 + i], c[i]);
        EXPECT_EQ(wide[12 + i], d[i]);
    }
}

} // namespace
} // namespace torrance
