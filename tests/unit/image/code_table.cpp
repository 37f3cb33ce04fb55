#include "image/code_table.h"

#include "image/srgb.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

CodeSteps stepsOf(double (*decode)(double))
{
    CodeSteps from;
    for (std::size_t code = 0; code < from.size(); ++code)
        from[code] = static_cast<float>(decode((static_cast<double>(code) + 0.5) / 255.0));
    return from;
}

double gammaDecode(double x)
{
    return std::pow(x, 2.2);
}

double unchanged(double x)
{
    return x;
}

TEST(CodeTable, CountsTheStepsBelow)
{
    for (double (*decode)(double) : {static_cast<double (*)(double)>(srgbDecode), gammaDecode, unchanged}) {
        const CodeSteps from = stepsOf(decode);
        const CodeTable codes(from);
        const CodeTable::Lookup table = codes.lookup();
        const auto expected = [&](float x) { return std::upper_bound(from.begin(), from.end(), x) - from.begin(); };
        for (const float step : from) {
            const auto bits = std::bit_cast<std::uint32_t>(step);
            for (std::uint32_t near = bits - 3; near <= bits + 3; ++near) {
                const auto x = std::bit_cast<float>(near);
                ASSERT_EQ(table(x), expected(x)) << x;
                ASSERT_EQ(table(Float4{0.5f, x, 1.0f, 0.0f})[1], expected(x)) << x;
            }
        }
        // The whole axis at a pace that is no power of two, and its ends.
        for (std::uint32_t bits = 0; bits <= std::bit_cast<std::uint32_t>(1.0f); bits += 7919) {
            const auto x = std::bit_cast<float>(bits);
            ASSERT_EQ(table(x), expected(x)) << x;
        }
        EXPECT_EQ(table(0.0f), 0);
        EXPECT_EQ(table(1.0f), 255);
    }
}

} // namespace
} // namespace torrance
