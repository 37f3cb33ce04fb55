#include "reference/texture_sampling.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

/// A row of grey 8-bit texels.
TextureImage greyRow(const std::vector<int>& values)
{
    TextureImage image;
    image.width = static_cast<int>(values.size());
    image.height = 1;
    for (const int v : values)
        for (int c = 0; c < 4; ++c)
            image.texels.push_back(static_cast<std::byte>(v));
    return image;
}

double red(const TextureImage& image, const Sampler& sampler, double u)
{
    return sampleImage(image, sampler, dvec2(u, 0.5), ColorSpace::linear).r;
}

constexpr Sampler samplerOf(Wrap wrap, Filter filter)
{
    return {.wrapS = wrap, .wrapT = wrap, .magnify = filter, .minify = filter, .mip = MipFilter::none};
}

TEST(TextureSampling, WrapsIndicesAsVulkanDoes)
{
    // Vulkan 1.3, "Wrapping Operation".
    const int repeat[] = {2, 0, 1, 2, 0, 1, 2, 0};
    const int mirror[] = {0, 0, 1, 2, 2, 1, 0, 0};
    const int clamp[] = {0, 0, 1, 2, 2, 2, 2, 2};
    for (int i = -1; i <= 6; ++i) {
        EXPECT_EQ(wrapIndex(i, 3, Wrap::repeat), repeat[i + 1]) << i;
        EXPECT_EQ(wrapIndex(i, 3, Wrap::mirroredRepeat), mirror[i + 1]) << i;
        EXPECT_EQ(wrapIndex(i, 3, Wrap::clampToEdge), clamp[i + 1]) << i;
    }
    EXPECT_EQ(wrapIndex(-4000000000001LL, 1, Wrap::mirroredRepeat), 0);
}

TEST(TextureSampling, BilinearMeetsTexelsAtTheirCentres)
{
    const TextureImage image = greyRow({0, 255});
    const Sampler sampler = samplerOf(Wrap::clampToEdge, Filter::linear);
    EXPECT_DOUBLE_EQ(red(image, sampler, 0.25), 0.0);
    EXPECT_DOUBLE_EQ(red(image, sampler, 0.75), 1.0);
    EXPECT_DOUBLE_EQ(red(image, sampler, 0.5), 0.5);
    EXPECT_DOUBLE_EQ(red(image, sampler, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(red(image, samplerOf(Wrap::repeat, Filter::linear), 0.0), 0.5) << "the other end is the neighbour";
    EXPECT_DOUBLE_EQ(red(image, samplerOf(Wrap::mirroredRepeat, Filter::linear), 0.0), 0.0);
}

TEST(TextureSampling, NearestTakesTheTexelThatCoversThePoint)
{
    const TextureImage image = greyRow({0, 51, 255});
    const Sampler sampler = samplerOf(Wrap::repeat, Filter::nearest);
    EXPECT_DOUBLE_EQ(red(image, sampler, 0.33), 0.0);
    EXPECT_DOUBLE_EQ(red(image, sampler, 0.34), 0.2);
    EXPECT_DOUBLE_EQ(red(image, sampler, 1.99), 1.0);
    EXPECT_DOUBLE_EQ(red(image, sampler, std::numeric_limits<double>::quiet_NaN()), 0.0);
    EXPECT_DOUBLE_EQ(red(image, samplerOf(Wrap::clampToEdge, Filter::nearest), 1e300), 1.0);
}

TEST(TextureSampling, DecodesSrgbBeforeItFiltersAndLeavesAlpha)
{
    // IEC 61966-2-1 gives 0.21586 for code 128 and 1/12.92 of the code below 0.04045.
    const dvec4 grey = texelAt(greyRow({128}), 0, 0, ColorSpace::srgb);
    EXPECT_NEAR(grey.r, 0.2158605, 1e-7);
    EXPECT_DOUBLE_EQ(grey.a, 128.0 / 255.0);
    EXPECT_NEAR(texelAt(greyRow({10}), 0, 0, ColorSpace::srgb).g, 10.0 / 255.0 / 12.92, 1e-15);
    const dvec4 middle =
        sampleImage(greyRow({0, 255}), samplerOf(Wrap::clampToEdge, Filter::linear), dvec2(0.5), ColorSpace::srgb);
    EXPECT_NEAR(middle.r, 0.5, 1e-12) << "0.2140 would be the filter on encoded values";
}

TEST(TextureSampling, SixteenBitsKeepSixteenBits)
{
    TextureImage image;
    image.width = image.height = 1;
    image.format = TexelFormat::rgba16;
    const std::uint16_t values[4] = {1, 32769, 65535, 257};
    image.texels.resize(sizeof values);
    std::memcpy(image.texels.data(), values, sizeof values);
    const dvec4 texel = texelAt(image, 0, 0, ColorSpace::linear);
    EXPECT_DOUBLE_EQ(texel.r, 1.0 / 65535.0);
    EXPECT_DOUBLE_EQ(texel.g, 32769.0 / 65535.0);
    EXPECT_DOUBLE_EQ(texel.b, 1.0);
    EXPECT_DOUBLE_EQ(texel.a, 1.0 / 255.0);
}

TEST(TextureSampling, UsesApplyTheirTransformToTheirSet)
{
    Scene scene;
    scene.images.push_back(greyRow({0, 51, 102, 153}));
    scene.textures.push_back({0, samplerOf(Wrap::repeat, Filter::nearest)});
    TextureUse use{.texture = 0, .uvSet = 1};
    use.transform = glm::dmat3x2(0.5, 0.0, 0.0, 1.0, 0.25, 0.0); // u / 2 + 1/4
    const std::array<dvec2, 2> uvs = {dvec2(0.1), dvec2(0.9, 0.5)};
    EXPECT_DOUBLE_EQ(sampleUse(scene, use, uvs, ColorSpace::linear).r, 0.4) << "u = 0.7: the third texel";
    EXPECT_EQ(sampleUse(scene, TextureUse{}, uvs, ColorSpace::srgb), dvec4(1.0));
}

} // namespace
} // namespace torrance
