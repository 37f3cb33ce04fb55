#include "prepare/texture_levels.h"

#include "level_bytes.h"
#include "slow_levels.h"

#include "image/srgb.h"

#include <array>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <span>
#include <utility>
#include <vector>

namespace torrance {
namespace {

using test::levelBytes;

/// Numbers without a pattern, and with many that are alike (normals that cancel, ties of rounding).
TextureImage noise(int width, int height, TexelFormat format)
{
    TextureImage image{"noise", width, height, format, {}};
    std::uint32_t state = static_cast<std::uint32_t>(width * 7919 + height);
    const std::size_t bytes =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * bytesPerTexel(format);
    while (image.texels.size() < bytes) {
        state = state * 1664525u + 1013904223u; // Numerical Recipes' generator
        const std::uint32_t value = state >> 24;
        image.texels.push_back(static_cast<std::byte>((state & 0x300000u) == 0 ? (value & 1u) * 255u : value));
    }
    return image;
}

struct Kind
{
    const char* name;
    TexelFormat format;
    MipRule rule;
    TexelStorage storage;
};

void PrintTo(const Kind& kind, std::ostream* out)
{
    *out << kind.name;
}

using enum TexelFormat;
using enum TexelContent;

constexpr Kind kKinds[] = {
    {"color8", rgba8, {.content = color}, TexelStorage::half},
    {"weighted8", rgba8, {.content = color, .weighByAlpha = true}, TexelStorage::half},
    {"data8", rgba8, {.content = data}, TexelStorage::unorm8},
    {"normal8", rgba8, {.content = normal}, TexelStorage::unorm16},
    {"lengths8", rgba8, {.content = normal, .lengthInAlpha = true}, TexelStorage::unorm16},
    {"color16", rgba16, {.content = color}, TexelStorage::single},
    {"weighted16", rgba16, {.content = color, .weighByAlpha = true}, TexelStorage::single},
    {"data16", rgba16, {.content = data}, TexelStorage::unorm16},
    {"normal16", rgba16, {.content = normal}, TexelStorage::unorm16},
    {"lengths16", rgba16, {.content = normal, .lengthInAlpha = true}, TexelStorage::unorm16},
};

class TextureLevels : public ::testing::TestWithParam<Kind>
{
};

void expectSame(const TextureImage& image, const MipRule& rule, std::size_t gap = 0)
{
    const auto got = levelBytes(image, rule, gap), expected = test::slowLevels(image, rule);
    ASSERT_EQ(got.size(), expected.size());
    for (std::size_t level = 0; level < got.size(); ++level)
        EXPECT_EQ(got[level], expected[level]) << image.width << "x" << image.height << ", level " << level;
}

TEST_P(TextureLevels, AreThoseOfThePlainWayBitByBit)
{
    for (int height = 1; height <= 9; ++height)
        for (int width = 1; width <= 9; ++width)
            expectSame(noise(width, height, GetParam().format), GetParam().rule);
    // Strips with rows that two of them read, a rest of rows, and levels below the strips'.
    for (const auto& [width, height] : {std::pair(64, 64), {67, 130}, {130, 67}, {1, 300}, {300, 1}, {200, 333}})
        expectSame(noise(width, height, GetParam().format), GetParam().rule);
}

TEST_P(TextureLevels, LieAtTheRowPitchThatTheDeviceAsksFor)
{
    EXPECT_EQ(storageOf(GetParam().format, GetParam().rule), GetParam().storage);
    expectSame(noise(12, 70, GetParam().format), GetParam().rule, 40);
}

TEST_P(TextureLevels, AreAsManyAsThereIsRoomFor)
{
    const TextureImage image = noise(70, 45, GetParam().format);
    const auto all = levelBytes(image, GetParam().rule);
    for (int count = 1; count <= static_cast<int>(all.size()); ++count) {
        const auto some =
            levelBytes(image.width, image.height, count, GetParam().storage,
                       [&](std::span<const LevelMemory> levels) { writeLevels(image, GetParam().rule, levels); });
        EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin())) << count;
    }
}

TEST_P(TextureLevels, MayBeginAtACoarserOne)
{
    for (const auto& [width, height] : {std::pair(70, 45), {64, 128}}) {
        const TextureImage image = noise(width, height, GetParam().format);
        const auto all = levelBytes(image, GetParam().rule);
        for (std::size_t missing = 1; missing < all.size(); ++missing) {
            const auto rest = levelBytes(width, height, static_cast<int>(all.size()), GetParam().storage,
                                         [&](std::span<const LevelMemory> levels) {
                                             std::vector<LevelMemory> some(levels.begin(), levels.end());
                                             for (std::size_t level = 0; level < missing; ++level)
                                                 some[level] = {};
                                             writeLevels(image, GetParam().rule, some);
                                         });
            EXPECT_TRUE(
                std::equal(rest.begin() + std::ptrdiff_t(missing), rest.end(), all.begin() + std::ptrdiff_t(missing)))
                << missing;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, TextureLevels, ::testing::ValuesIn(kKinds),
                         [](const auto& test) { return std::string(test.param.name); });

// Channels of pictures of both formats, some of which nothing reads, against a picture put together code by code.
TEST(PackedLevels, AreThoseOfAPictureThatWasPutTogether)
{
    struct Case
    {
        std::array<TexelFormat, 4> formats;
        std::array<int, 4> channels;
        std::array<bool, 4> read;
    };
    const Case cases[] = {{{rgba8, rgba8, rgba8, rgba8}, {0, 1, 2, 1}, {true, true, true, true}},
                          {{rgba8, rgba8, rgba8, rgba8}, {2, 0, 3, 1}, {true, false, true, false}},
                          {{rgba16, rgba16, rgba16, rgba8}, {0, 1, 2, 2}, {true, true, true, true}},
                          {{rgba16, rgba16, rgba16, rgba16}, {1, 1, 0, 3}, {false, true, true, true}}};
    for (const Case& test : cases)
        for (const auto& [width, height] : {std::pair(1, 1), {6, 4}, {7, 5}, {90, 70}}) {
            std::array<TextureImage, 4> images;
            ChannelPictures pictures;
            for (std::size_t c = 0; c < 4; ++c) {
                images[c] = noise(width, height, test.formats[c]);
                for (std::byte& byte : images[c].texels)
                    byte ^= static_cast<std::byte>(c * 37);
                pictures.images[c] = test.read[c] ? &images[c] : nullptr;
                pictures.channels[c] = test.channels[c];
            }
            const TexelFormat format = std::ranges::find(test.formats, rgba16) == test.formats.end() ? rgba8 : rgba16;
            const std::size_t code = bytesPerTexel(format) / 4;
            TextureImage together{"together", width, height, format, {}};
            for (std::size_t i = 0; i < static_cast<std::size_t>(width * height); ++i)
                for (std::size_t c = 0; c < 4; ++c)
                    for (std::size_t byte = 0; byte < code; ++byte) {
                        const std::size_t own = bytesPerTexel(images[c].format) / 4; // of a code of this picture
                        const std::size_t at = (4 * i + static_cast<std::size_t>(test.channels[c])) * own + byte % own;
                        together.texels.push_back(test.read[c] ? images[c].texels[at] : std::byte(0xff));
                    }
            const MipRule rule = {.content = color};
            EXPECT_EQ(
                levelBytes(width, height, mipCount(width, height), storageOf(format, rule),
                           [&](std::span<const LevelMemory> levels) { writePackedLevels(pictures, rule, levels); }),
                levelBytes(together, rule))
                << width << "x" << height;
        }
}

/// A field of texel words as shaders/shared/texel_words.h describes it: its word, its lowest bit, its bits, and what
/// stands for 1.
struct Field
{
    std::size_t part, channel; // of ChannelPictures
    std::size_t word;
    unsigned lowest, bits;
    double one;
};
constexpr Field kFields[] = {{0, 0, 0, 0, 11, 2047},  {0, 1, 0, 11, 11, 2047}, {0, 2, 1, 0, 11, 2047},
                             {0, 3, 2, 24, 8, 255},   {1, 0, 2, 0, 12, 4080},  {1, 1, 2, 12, 12, 4080},
                             {1, 2, 3, 0, 12, 4080},  {1, 3, 0, 22, 10, 1020}, {2, 0, 1, 11, 11, 2047},
                             {2, 1, 3, 12, 11, 2047}, {2, 2, 1, 22, 10, 1023}, {2, 3, 3, 23, 9, 510}};

/// Of a half float that is not negative, and finite.
double halfValue(std::uint16_t bits)
{
    const int exponent = bits >> 10, fraction = bits & 0x3ff;
    return exponent > 0 ? std::ldexp(0x400 + fraction, exponent - 25) : std::ldexp(fraction, -24);
}

/// What a field stands for: of colours the square root.
double fieldAt(const std::vector<std::byte>& level, std::size_t texel, const Field& field)
{
    std::uint32_t word = 0;
    std::memcpy(&word, level.data() + 16 * texel + 4 * field.word, sizeof word);
    return ((word >> field.lowest) & ((1u << field.bits) - 1u)) / field.one;
}

/// Three parts of four pictures each, and their levels as texel words and as three textures.
struct WordCase
{
    std::array<std::array<TextureImage, 4>, 3> images;
    WordPictures parts;
    std::vector<std::vector<std::byte>> words;
    std::array<std::vector<std::vector<std::byte>>, 3> apart;

    WordCase(int width, int height, const std::array<bool, 3>& read)
    {
        for (std::size_t p = 0; p < 3; ++p)
            for (std::size_t c = 0; c < 4; ++c) {
                images[p][c] = noise(width, height, rgba8);
                for (std::byte& byte : images[p][c].texels)
                    byte ^= static_cast<std::byte>((4 * p + c) * 37);
                parts[p].images[c] = read[p] ? &images[p][c] : nullptr;
                parts[p].channels[c] = static_cast<int>((p + c) % 4);
            }
        const int count = mipCount(width, height);
        words = levelBytes(width, height, count, TexelStorage::words,
                           [&](std::span<const LevelMemory> levels) { writeWordLevels(parts, levels); });
        for (std::size_t p = 0; p < 3; ++p) {
            const MipRule rule = {.content = p == 1 ? normal : color};
            if (read[p])
                apart[p] =
                    levelBytes(width, height, count, storageOf(rgba8, rule),
                               [&](std::span<const LevelMemory> levels) { writePackedLevels(parts[p], rule, levels); });
        }
    }
};

constexpr std::pair<int, int> kWordSizes[] = {{1, 1}, {6, 4}, {7, 5}, {90, 70}, {256, 128}};

TEST(WordLevels, HoldTheCodesOfTheFile)
{
    for (const auto& [width, height] : kWordSizes) {
        const WordCase c(width, height, {true, true, true});
        for (std::size_t i = 0; i < static_cast<std::size_t>(width * height); ++i)
            for (const Field& field : kFields) {
                const auto from = static_cast<std::size_t>(c.parts[field.part].channels[field.channel]);
                const double code =
                    std::to_integer<int>(c.images[field.part][field.channel].texels[4 * i + from]) / 255.0;
                const double value = fieldAt(c.words[0], i, field);
                if (field.part != 1 && field.channel < 3) // half a step of square roots
                    ASSERT_NEAR(value, std::sqrt(srgbDecode(code)), 0.5001 / field.one);
                else
                    ASSERT_EQ(value, code) << field.part << ", " << field.channel;
            }
    }
}

// Of textures apart, halves of colours and scalars are off by 2^-12 of them, normals by half a step of 16 bits.
TEST(WordLevels, AreThoseOfTexturesApart)
{
    for (const auto& [width, height] : kWordSizes) {
        const WordCase c(width, height, {true, true, true});
        for (std::size_t level = 1; level < c.words.size(); ++level)
            for (std::size_t i = 0; i < c.words[level].size() / 16; ++i)
                for (const Field& field : kFields) {
                    std::uint16_t bits = 0;
                    std::memcpy(&bits, c.apart[field.part][level].data() + 8 * i + 2 * field.channel, sizeof bits);
                    const double apart = field.part == 1 ? bits / 65535.0 : halfValue(bits);
                    const bool root = field.part != 1 && field.channel < 3;
                    ASSERT_NEAR(fieldAt(c.words[level], i, field), root ? std::sqrt(apart) : apart,
                                0.5 / field.one + 0x1p-12)
                        << "level " << level << ", " << field.part << ", " << field.channel;
                }
    }
}

TEST(WordLevels, LeaveTheFieldsOfWhatIsNotThereEmpty)
{
    for (const std::array<bool, 3> read : {std::array{true, false, false}, {false, true, true}, {true, false, true}}) {
        const WordCase c(12, 7, read);
        const WordCase whole(12, 7, {true, true, true});
        for (std::size_t level = 0; level < c.words.size(); ++level)
            for (std::size_t i = 0; i < c.words[level].size() / 16; ++i)
                for (const Field& field : kFields)
                    ASSERT_EQ(fieldAt(c.words[level], i, field),
                              read[field.part] ? fieldAt(whole.words[level], i, field) : 0.0);
    }
}

} // namespace
} // namespace torrance
