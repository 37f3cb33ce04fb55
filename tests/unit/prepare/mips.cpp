#include "prepare/mips.h"

#include "image/srgb.h"
#include "level_bytes.h"
#include "math/half.h"
#include "math/vector.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <span>

namespace torrance {
namespace {

using Code = std::array<int, 4>;

TextureImage image(int width, int height, const std::vector<Code>& codes, TexelFormat format = TexelFormat::rgba8)
{
    TextureImage out{"test", width, height, format, {}};
    for (const Code& texel : codes)
        for (const int code : texel) {
            const auto value = static_cast<std::uint16_t>(code);
            const auto bytes = std::as_bytes(std::span(&value, 1));
            out.texels.insert(out.texels.end(), bytes.begin(), bytes.begin() + (format == TexelFormat::rgba8 ? 1 : 2));
        }
    return out;
}

Code codeAt(const TextureImage& picture, int x, int y)
{
    Code out{};
    const std::size_t size = bytesPerTexel(picture.format) / 4;
    for (std::size_t c = 0; c < 4; ++c) {
        std::uint16_t value = 0;
        std::memcpy(&value, picture.texels.data() + (static_cast<std::size_t>(y * picture.width + x) * 4 + c) * size,
                    size);
        out[c] = value;
    }
    return out;
}

double fromHalf(std::uint16_t half) // not negative, finite
{
    const int exponent = half >> 10, fraction = half & 0x3ff;
    return exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
}

/// What the device holds, in [0, 1]: of colours light.
double numberAt(const std::byte* texels, TexelStorage storage, std::size_t i)
{
    const auto number = [&](auto value) {
        std::memcpy(&value, texels + i * sizeof value, sizeof value);
        return value;
    };
    switch (storage) {
    case TexelStorage::unorm8:
        return number(std::uint8_t()) / 255.0;
    case TexelStorage::unorm16:
        return number(std::uint16_t()) / 65535.0;
    case TexelStorage::half:
        return fromHalf(number(std::uint16_t()));
    case TexelStorage::single:
        break;
    }
    return double(number(0.0f));
}

/// The code next to what the device holds: of 8 bits, or of 16.
int codeAt(const std::byte* texels, TexelStorage storage, std::size_t i)
{
    const bool light = storage == TexelStorage::half || storage == TexelStorage::single;
    const bool wide = storage == TexelStorage::unorm16 || storage == TexelStorage::single;
    const double value = numberAt(texels, storage, i);
    return static_cast<int>(std::lround((light && i % 4 != 3 ? srgbEncode(value) : value) * (wide ? 65535.0 : 255.0)));
}

/// What writeLevels gives, in codes again: level 1 and on, of the format of `base` or of 16 bits.
std::vector<TextureImage> makeMips(const TextureImage& base, const MipRule& rule)
{
    const TexelStorage storage = storageOf(base.format, rule);
    std::vector<TextureImage> levels;
    for (const std::vector<std::byte>& stored : test::levelBytes(base, rule)) {
        const auto level = static_cast<int>(levels.size());
        std::vector<Code> codes(stored.size() / bytesPerTexel(storage));
        for (std::size_t i = 0; i < 4 * codes.size(); ++i)
            codes[i / 4][i % 4] = codeAt(stored.data(), storage, i);
        levels.push_back(image(std::max(1, base.width >> level), std::max(1, base.height >> level), codes,
                               storage == TexelStorage::unorm16 ? TexelFormat::rgba16 : base.format));
    }
    levels.erase(levels.begin());
    return levels;
}

TextureImage levelZero(const TextureImage& base, const MipRule& rule)
{
    return {base.name, base.width, base.height, TexelFormat::rgba16, test::levelBytes(base, rule)[0]};
}

TEST(Mips, EndAtOneTexel)
{
    EXPECT_EQ(mipCount(1, 1), 1);
    EXPECT_EQ(mipCount(5, 3), 3); // 5x3, 2x1, 1x1
    EXPECT_EQ(mipCount(4096, 1), 13);
    const auto levels = makeMips(image(5, 3, std::vector<Code>(15, Code{10, 20, 30, 40})), {TexelContent::data});
    ASSERT_EQ(levels.size(), 2u);
    EXPECT_EQ(levels[0].width, 2);
    EXPECT_EQ(levels[0].height, 1);
    EXPECT_EQ(levels[1].width, 1);
    EXPECT_EQ(codeAt(levels[1], 0, 0), (Code{10, 20, 30, 40})) << "an even picture stays even";
    EXPECT_TRUE(makeMips(image(1, 1, {{1, 2, 3, 4}}), {}).empty());
}

TEST(Mips, EveryCodeOfAnEvenPictureSurvives)
{
    for (const TexelContent content : {TexelContent::color, TexelContent::data})
        for (int code = 0; code < 256; ++code) {
            const Code texel{code, 255 - code, code, code};
            EXPECT_EQ(codeAt(makeMips(image(3, 3, std::vector<Code>(9, texel)), {content})[0], 0, 0), texel);
        }
    for (int code = 0; code < 65536; code += 257)
        EXPECT_EQ(
            codeAt(makeMips(image(2, 1, std::vector<Code>(2, Code{code, 0, code, code}), TexelFormat::rgba16), {})[0],
                   0, 0),
            (Code{code, 0, code, code}));
}

TEST(Mips, ColourIsAveragedAsLightAlphaAsItIs)
{
    // Half black, half white is half of the light: sRGB 187.516 (the curve's own value of 0.5); alpha 127.5 rounds to
    // even.
    const auto level = makeMips(image(2, 1, {{0, 0, 255, 0}, {255, 255, 255, 255}}), {TexelContent::color})[0];
    EXPECT_EQ(codeAt(level, 0, 0), (Code{188, 188, 255, 128}));
    const auto data = makeMips(image(2, 1, {{0, 0, 255, 0}, {255, 255, 255, 255}}), {TexelContent::data})[0];
    EXPECT_EQ(codeAt(data, 0, 0), (Code{128, 128, 255, 128}));
}

TEST(Mips, MeansOfColoursAreNotRoundedToCodes)
{
    // Every mean of two codes, against the curve in double: but for the rounding of a half, and of the floats before
    // it.
    for (int a = 0; a < 256; ++a)
        for (int b = a; b < 256; b += 7) {
            const double mean = 0.5 * (srgbDecode(a / 255.0) + srgbDecode(b / 255.0));
            const TextureImage pair = image(2, 1, {{a, 0, 0, 255}, {b, 0, 0, 255}});
            const std::vector<std::byte> level = test::levelBytes(pair, {TexelContent::color})[1];
            const double rounding = std::max(std::ldexp(mean, -11), std::ldexp(1.0, -25)); // of 11 bits; of a subnormal
            EXPECT_NEAR(numberAt(level.data(), TexelStorage::half, 0), mean, rounding + 1e-7 * mean)
                << a << " and " << b;
        }
}

TEST(Mips, NormalsOfEightBitsLieInSixteenAndMeansBetweenThem)
{
    // Level 0 is the file's codes. The mean of 128 and 131 is 129.5, which 8 bits have not.
    const TextureImage pair = image(2, 1, {{128, 127, 255, 9}, {131, 127, 255, 9}});
    const std::vector<std::vector<std::byte>> levels = test::levelBytes(pair, {TexelContent::normal});
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_EQ(numberAt(levels[0].data(), TexelStorage::unorm16, i),
                  Code({i < 4 ? 128 : 131, 127, 255, 9})[i % 4] / 255.0);
    const double x = 2.0 * 129.5 / 255.0 - 1.0, y = 2.0 * 127.0 / 255.0 - 1.0;
    EXPECT_NEAR(numberAt(levels[1].data(), TexelStorage::unorm16, 0), 0.5 + 0.5 * x / std::sqrt(x * x + y * y + 1.0),
                0.5 / 65535.0 + 1e-7);
}

TEST(Mips, SixteenBitsStaySixteen)
{
    const auto level =
        makeMips(image(2, 1, {{1000, 0, 0, 0}, {1003, 0, 0, 65535}}, TexelFormat::rgba16), {TexelContent::data})[0];
    EXPECT_EQ(level.format, TexelFormat::rgba16);
    EXPECT_NEAR(codeAt(level, 0, 0)[0], 1001.5, 0.5);
}

TEST(Mips, AnOddSideNeitherShiftsNorDropsATexel)
{
    // A bright texel of 5 covers [i, i + 1] / 5: of the two coarser texels the left one covers [0, 2.5] / 5. Its share
    // is the overlap over 2.5, in units of 250: 100, 100, 50, 0, 0 and the mirror image on the right.
    const int left[5] = {100, 100, 50, 0, 0};
    for (int i = 0; i < 5; ++i) {
        std::vector<Code> texels(5, Code{0, 0, 0, 0});
        texels[static_cast<std::size_t>(i)] = {250, 250, 250, 250};
        const auto level = makeMips(image(5, 1, texels), {TexelContent::data})[0];
        EXPECT_EQ(codeAt(level, 0, 0)[0], left[i]) << "texel " << i;
        EXPECT_EQ(codeAt(level, 1, 0)[0], left[4 - i]) << "texel " << i;
    }
}

TEST(Mips, NothingShiftsDownTheChain)
{
    // A ramp over an odd width is its own mirror image about the middle, and so is every level; its mean is the ramp's.
    const int width = 201;
    std::vector<Code> ramp;
    for (int i = 0; i < width; ++i)
        ramp.push_back({i * 300, 0, 0, 0});
    for (const TextureImage& level : makeMips(image(width, 1, ramp, TexelFormat::rgba16), {TexelContent::data})) {
        double sum = 0.0;
        for (int i = 0; i < level.width; ++i) {
            sum += codeAt(level, i, 0)[0];
            EXPECT_NEAR(codeAt(level, i, 0)[0] + codeAt(level, level.width - 1 - i, 0)[0], 300 * (width - 1), 1)
                << "width " << level.width << " texel " << i;
        }
        EXPECT_NEAR(sum / level.width, 150.0 * (width - 1), 0.5) << "width " << level.width;
    }
}

TEST(Mips, HiddenColourDoesNotBleedThroughAlpha)
{
    const std::vector<Code> leaf = {{200, 0, 0, 255}, {0, 255, 0, 0}};
    EXPECT_EQ(codeAt(makeMips(image(2, 1, leaf), {TexelContent::color, true})[0], 0, 0), (Code{200, 0, 0, 128}));
    EXPECT_GT(codeAt(makeMips(image(2, 1, leaf), {TexelContent::color, false})[0], 0, 0)[1], 100);
    const std::vector<Code> hidden = {{100, 50, 0, 0}, {100, 50, 0, 0}};
    EXPECT_EQ(codeAt(makeMips(image(2, 1, hidden), {TexelContent::color, true})[0], 0, 0), (Code{100, 50, 0, 0}));
}

TEST(Mips, NormalsStayUnit)
{
    // The mean of (sin, 0, cos) of +60 and 0 degrees points along 30 degrees.
    const auto encode = [](double angle) {
        return Code{static_cast<int>(std::lround(32767.5 * (1 + std::sin(angle)))), 32768,
                    static_cast<int>(std::lround(32767.5 * (1 + std::cos(angle)))), 65535};
    };
    const auto level =
        makeMips(image(2, 1, {encode(kPi / 3), encode(0)}, TexelFormat::rgba16), {TexelContent::normal})[0];
    const Code expected = encode(kPi / 6), got = codeAt(level, 0, 0);
    for (std::size_t c = 0; c < 4; ++c)
        EXPECT_NEAR(got[c], expected[c], 2) << "channel " << c;
    // opposite ones give +Z
    EXPECT_EQ(codeAt(makeMips(image(2, 1, {{255, 0, 0, 0}, {0, 255, 255, 0}}), {TexelContent::normal})[0], 0, 0),
              (Code{32768, 32768, 65535, 0}));
}

// Two normals that lean by 0.6 either way: their mean is straight up and 0.8 long.
TEST(Mips, KeepTheLengthOfMeanNormalsInAlpha)
{
    TextureImage leaning{"leaning", 2, 2, TexelFormat::rgba8, {}};
    for (const double x : {0.6, -0.6, -0.6, 0.6})
        for (const double value : {0.5 + 0.5 * x, 0.5, 0.9, 0.3})
            leaning.texels.push_back(static_cast<std::byte>(std::lround(value * 255.0)));
    const MipRule rule = {.content = TexelContent::normal, .lengthInAlpha = true};
    ASSERT_EQ(storageOf(leaning.format, rule), TexelStorage::unorm16);
    const TextureImage wide = levelZero(leaning, rule);
    const auto channel = [](const TextureImage& image, std::size_t i) {
        std::uint16_t code;
        std::memcpy(&code, image.texels.data() + 2 * i, sizeof code);
        return code / 65535.0;
    };
    for (std::size_t texel = 0; texel < 4; ++texel) {
        double length2 = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
            length2 += std::pow(2.0 * channel(wide, 4 * texel + c) - 1.0, 2);
        EXPECT_NEAR(length2, 1.0, 1e-4) << "unit, although 8 bits were not";
        EXPECT_EQ(channel(wide, 4 * texel + 3), 1.0) << "what was in alpha is not read";
    }
    const std::vector<TextureImage> levels = makeMips(leaning, rule);
    ASSERT_EQ(levels.size(), 1u);
    EXPECT_NEAR(channel(levels[0], 0), 0.5, 2e-3) << "the halves of 0.5 and of 255 codes differ by half a code";
    EXPECT_NEAR(channel(levels[0], 2), 1.0, 1e-4);
    EXPECT_NEAR(channel(levels[0], 3), 0.8, 3e-3) << "8-bit normals lean by 0.6 within a code";
}

} // namespace
} // namespace torrance
