// Codes made four pixels at a time, against those of the picture that toDisplay makes.
#include "image/code_rows.h"

#include "image/quantize.h"

#include <bit>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

std::vector<std::uint8_t> quantizedCodes(const Image& image, int bits)
{
    std::vector<std::uint8_t> codes;
    for (const float value : image.texels) {
        const std::uint16_t code = quantized(value, bits == 8 ? 255 : 65535);
        if (bits == 16)
            codes.push_back(static_cast<std::uint8_t>(code >> 8));
        codes.push_back(static_cast<std::uint8_t>(code & 255));
    }
    return codes;
}

/// Numbers of every size that light has, now and then one that is none.
Image anything(int width, int height, int channels)
{
    constexpr float kSpecial[] = {0.0f, -0.0f, -1.0f, 1e-40f, 1.0f, 65504.0f, 3e38f, kInfinity, -kInfinity, kNaN};
    Image image(width, height, channels);
    std::uint32_t state = 1;
    for (std::size_t i = 0; i < image.texels.size(); ++i) {
        state = state * 1664525u + 1013904223u; // Numerical Recipes' generator
        const float fraction = static_cast<float>(state >> 8) / static_cast<float>(1 << 24);
        const bool isAlpha = channels == 4 && i % 4 == 3;
        image.texels[i] = (state & 0xf0u) == 0 ? kSpecial[(state >> 24) % std::size(kSpecial)]
                          : isAlpha            ? std::min(1.0f, 2.0f * fraction)
                                               : std::exp2(20.0f * fraction - 14.0f);
    }
    return image;
}

TEST(CodeRows, AreThoseOfThePictureForScreens)
{
    for (const ToneCurve& tone : allToneCurves())
        for (const TransferCurve& transfer : allTransferCurves())
            for (const AlphaRule alpha : {AlphaRule::straight, AlphaRule::overBlack})
                for (const int channels : {3, 4})
                    for (const int width : {1, 2, 3, 4, 5, 333})
                        for (const int bits : {8, 16}) {
                            const DisplaySettings settings = {
                                .exposure = 0.7, .tone = &tone, .transfer = &transfer, .alpha = alpha};
                            const Image image = anything(width, 40, channels), shown = toDisplay(image, settings);
                            const CodeRows rows = displayRows(image, settings, bits);
                            EXPECT_EQ(rows.width, width);
                            EXPECT_EQ(rows.height, 40);
                            EXPECT_EQ(rows.channels, shown.channels);
                            EXPECT_EQ(rows.bits, bits);
                            EXPECT_TRUE(allCodes(rows) == quantizedCodes(shown, bits))
                                << tone.id << ", " << transfer.id << ", " << width << " x " << channels << ", " << bits
                                << " bits";
                        }
}

// The floats on both sides of every step of every transfer curve, as the curve itself is computed.
TEST(CodeRows, RiseWhereTheCurveDoes)
{
    for (const TransferCurve& transfer : allTransferCurves()) {
        Image image(101, 255, 3);
        std::uint32_t below = 0; // the bits of the last float below the step
        for (int code = 0; code < 255; ++code) {
            for (std::uint32_t pace = 1u << 29; pace > 0; pace /= 2) {
                const auto x = std::bit_cast<float>(below + pace);
                if (x <= 1.0f && quantized(transfer.single(x), 255) <= code)
                    below += pace;
            }
            for (int i = 0; i < 101; ++i)
                for (int c = 0; c < 3; ++c)
                    image.at(i, code)[c] = std::bit_cast<float>(below + static_cast<std::uint32_t>(i) - 50u);
        }
        const DisplaySettings settings = {.tone = findToneCurve("none"), .transfer = &transfer};
        const std::vector<std::uint8_t> codes = allCodes(displayRows(image, settings, 8));
        EXPECT_TRUE(codes == quantizedCodes(toDisplay(image, settings), 8)) << transfer.id;
        for (std::size_t code = 0; code < 255; ++code) {
            EXPECT_EQ(codes[code * 303], code) << transfer.id << ": the steps were missed";
            EXPECT_EQ(codes[code * 303 + 302], code + 1) << transfer.id << ": the steps were missed";
        }
    }
}

TEST(CodeRows, QuantizeWhatIsEncodedAlready)
{
    for (const int channels : {1, 3, 4})
        for (const int bits : {8, 16}) {
            const Image image = anything(37, 9, channels);
            const CodeRows rows = quantizedRows(image, bits);
            EXPECT_EQ(rows.rowBytes(), static_cast<std::size_t>(37 * channels * bits / 8));
            EXPECT_TRUE(allCodes(rows) == quantizedCodes(image, bits)) << channels << " channels, " << bits << " bits";
        }
}

} // namespace
} // namespace torrance
