#include "image/quantize.h"

#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

TEST(Quantize, KeepsEveryCodeOfBothDepths)
{
    for (const int maximum : {255, 65535})
        for (int code = 0; code <= maximum; ++code)
            EXPECT_EQ(quantized(dequantized(static_cast<std::uint16_t>(code), static_cast<std::uint16_t>(maximum)),
                                static_cast<std::uint16_t>(maximum)),
                      code);
}

TEST(Quantize, RoundsHalvesToEven)
{
    // Halves that a float holds exactly: k/4 of a maximum of 2.
    EXPECT_EQ(quantized(0.25f, 2), 0);
    EXPECT_EQ(quantized(0.75f, 2), 2);
}

TEST(Quantize, ClipsAndDefinesNan)
{
    EXPECT_EQ(quantized(std::numeric_limits<float>::quiet_NaN(), 255), 0);
    EXPECT_EQ(quantized(-1.0f, 255), 0);
    EXPECT_EQ(quantized(65504.0f, 255), 255);
    EXPECT_EQ(quantized(std::numeric_limits<float>::infinity(), 65535), 65535);
}

} // namespace
} // namespace torrance
