// Channels of several pictures in one.
#include "files/channel_pack.h"

#include "files/height_map.h"
#include "image/srgb.h"
#include "pictures.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

using test::grey16;
using test::grey8;
using test::picture8;

TEST(ChannelPack, KeepsCodesWhereSizesAgree)
{
    const TextureImage roughness = grey8(3, 2, {0, 1, 2, 127, 254, 255});
    const TextureImage metallic = grey8(3, 2, {255, 0, 128, 1, 2, 3});
    const TextureImage packed = packChannels(
        "both", {PackedChannel{}, {&roughness, Channel::luminance}, {&metallic, Channel::red}, {}}, Wrap::repeat);
    ASSERT_EQ(packed.format, TexelFormat::rgba8);
    ASSERT_EQ(packed.texels.size(), 24u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(packed.texels[4 * i], std::byte(255)) << "1 where there is no source";
        EXPECT_EQ(packed.texels[4 * i + 1], roughness.texels[4 * i]);
        EXPECT_EQ(packed.texels[4 * i + 2], metallic.texels[4 * i]);
    }
}

TEST(ChannelPack, KeepsSixteenBits)
{
    const TextureImage roughness = grey16(2, 1, {12345, 12346});
    const TextureImage metallic = grey8(2, 1, {7, 255});
    const TextureImage packed = packChannels(
        "both", {PackedChannel{}, {&roughness, Channel::luminance}, {&metallic, Channel::luminance}, {}}, Wrap::repeat);
    ASSERT_EQ(packed.format, TexelFormat::rgba16);
    EXPECT_DOUBLE_EQ(texelValue(packed, 0, 0, Channel::green), 12345 / 65535.0);
    EXPECT_DOUBLE_EQ(texelValue(packed, 1, 0, Channel::green), 12346 / 65535.0);
    EXPECT_DOUBLE_EQ(texelValue(packed, 0, 0, Channel::blue), 7 / 255.0) << "8 bits lie among the 16: code times 257";
}

TEST(ChannelPack, EnlargesTheSmallerAsASamplerFilters)
{
    const TextureImage wide = grey8(4, 1, {0, 0, 0, 0});
    const TextureImage narrow = grey8(2, 1, {0, 255});
    const TextureImage packed = packChannels(
        "both", {PackedChannel{}, {&wide, Channel::luminance}, {&narrow, Channel::luminance}, {}}, Wrap::repeat);
    ASSERT_EQ(packed.width, 4);
    ASSERT_EQ(packed.format, TexelFormat::rgba16) << "what lies between two codes is kept";
    // Middles of four texels in a picture of two: at u = -1/4, 1/4, 3/4, 5/4 of its texels.
    const std::array expected = {0.25, 0.25, 0.75, 0.75};
    for (int x = 0; x < 4; ++x)
        EXPECT_NEAR(texelValue(packed, x, 0, Channel::blue), expected[static_cast<std::size_t>(x)], 1.0 / 65535.0);
    const TextureImage clamped = packChannels(
        "both", {PackedChannel{}, {&wide, Channel::luminance}, {&narrow, Channel::luminance}, {}}, Wrap::clampToEdge);
    EXPECT_EQ(texelValue(clamped, 0, 0, Channel::blue), 0.0);
    EXPECT_EQ(texelValue(clamped, 3, 0, Channel::blue), 1.0);
}

TEST(ChannelPack, ColoursAreEnlargedInLinearLight)
{
    const TextureImage opacity = grey8(4, 1, {255, 255, 255, 255});
    const TextureImage color = grey8(2, 1, {0, 255});
    const PackedChannel red{&color, Channel::red, 1.0, {}, true};
    const TextureImage packed = packChannels("c", {red, red, red, {&opacity, Channel::red}}, Wrap::clampToEdge);
    EXPECT_NEAR(texelValue(packed, 1, 0, Channel::red), srgbEncode(0.25), 1.0 / 65535.0);
}

TEST(ChannelPack, KnowsGreyAndAlpha)
{
    EXPECT_TRUE(isGrey(grey8(2, 1, {0, 200})));
    EXPECT_FALSE(isGrey(picture8(1, 1, {10, 10, 11, 255})));
    EXPECT_FALSE(hasAlpha(grey16(2, 1, {0, 200})));
    EXPECT_TRUE(hasAlpha(picture8(1, 1, {10, 10, 10, 254})));
    EXPECT_NEAR(texelValue(picture8(1, 1, {255, 0, 0, 255}), 0, 0, Channel::luminance), 0.2126, 1e-12);
}

TEST(HeightMap, SlopesBecomeNormals)
{
    // A ramp that rises by 51/255 = 0.2 a texel to the right, 5 texels high: slope 1, so 45 degrees to the left.
    const TextureImage ramp = grey8(6, 1, {0, 51, 102, 153, 204, 255});
    const TextureImage normals = normalsOfHeights(ramp, Channel::luminance, 5.0, Wrap::clampToEdge);
    ASSERT_EQ(normals.format, TexelFormat::rgba16);
    const double half = std::sqrt(0.5);
    for (int x = 1; x < 5; ++x) {
        EXPECT_NEAR(2.0 * texelValue(normals, x, 0, Channel::red) - 1.0, -half, 2.0 / 65535.0);
        EXPECT_NEAR(2.0 * texelValue(normals, x, 0, Channel::green) - 1.0, 0.0, 2.0 / 65535.0);
        EXPECT_NEAR(2.0 * texelValue(normals, x, 0, Channel::blue) - 1.0, half, 2.0 / 65535.0);
    }
}

TEST(HeightMap, UpInThePictureIsPlusY)
{
    const TextureImage ramp = grey8(1, 3, {255, 153, 51}); // highest at the top: it faces down, -Y
    const TextureImage normals = normalsOfHeights(ramp, Channel::luminance, 1.0, Wrap::clampToEdge);
    EXPECT_LT(2.0 * texelValue(normals, 0, 1, Channel::green) - 1.0, -0.3);
}

} // namespace
} // namespace torrance
