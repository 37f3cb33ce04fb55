#include "prepare/texture_levels.h"

#include "level_bytes.h"
#include "slow_levels.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace torrance
