// PNG files written stripe by stripe, read by libpng.
#include "files/image_encoders.h"
#include "libpng_oracle.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

/// Rows that are smooth, equal, or without any pattern, so that runs of all lengths come up.
CodeRows rowsOf(int width, int height, int channels, int bits)
{
    return {width, height, channels, bits, [=](int y, std::uint8_t* codes) {
                std::uint32_t state = static_cast<std::uint32_t>(y);
                for (int i = 0; i < width * channels * bits / 8; ++i) {
                    state = state * 1664525u + 1013904223u; // Numerical Recipes' generator
                    codes[i] = static_cast<std::uint8_t>(y % 3 == 0 ? i / 7 + y : y % 3 == 1 ? 42u : state >> 24);
                }
            }};
}

/// The codes as libpng gives them: four channels, 16 bits in native order.
std::vector<std::byte> expectedTexels(const CodeRows& rows)
{
    const std::vector<std::uint8_t> codes = allCodes(rows);
    const std::size_t bytes = static_cast<std::size_t>(rows.bits / 8),
                      channels = static_cast<std::size_t>(rows.channels);
    std::vector<std::byte> texels;
    for (std::size_t i = 0; i < codes.size(); i += channels * bytes)
        for (std::size_t c = 0; c < 4; ++c) {
            const std::size_t from = i + (channels == 1 ? 0 : c) * bytes;
            std::byte number[2] = {std::byte(255), std::byte(255)};
            if (c < 3 || channels == 4)
                for (std::size_t k = 0; k < bytes; ++k)
                    number[k] = static_cast<std::byte>(codes[from + k]);
            if (bytes == 2 && std::endian::native == std::endian::little)
                std::swap(number[0], number[1]);
            texels.insert(texels.end(), number, number + bytes);
        }
    return texels;
}

std::string textOf(const std::vector<std::byte>& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(EncodePng, HoldsTheCodesThatItWasGiven)
{
    for (const int channels : {1, 3, 4})
        for (const int bits : {8, 16})
            // A texel, rows shorter than a vector, a rest of a stripe, rows longer than a stripe.
            for (const auto& [width, height] : {std::pair(1, 1), {3, 2}, {17, 5}, {700, 300}, {40000, 3}}) {
                const CodeRows rows = rowsOf(width, height, channels, bits);
                const test::LibpngResult read = test::readByLibpng(textOf(encodePng(rows)));
                ASSERT_TRUE(read.read) << read.problem;
                EXPECT_EQ(read.warnings, 0);
                EXPECT_EQ(read.image.width, width);
                EXPECT_EQ(read.image.height, height);
                EXPECT_TRUE(read.image.texels == expectedTexels(rows))
                    << width << "x" << height << "x" << channels << ", " << bits << " bits";
            }
}

TEST(EncodePng, IsMarkedAsSrgb)
{
    EXPECT_NE(textOf(encodePng(rowsOf(2, 2, 3, 8))).find("sRGB"), std::string::npos);
}

TEST(EncodePng, PacksWhatIsEvenIntoNextToNothing)
{
    const CodeRows even = {1000, 1000, 4, 8, [](int, std::uint8_t* codes) { std::fill_n(codes, 4000, 7); }};
    EXPECT_LT(encodePng(even).size(), 4000000u / 200);
}

} // namespace
} // namespace torrance
