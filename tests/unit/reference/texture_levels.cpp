#include "reference/texture_levels.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

/// Texels of one row after the other, each with all four channels.
TextureImage imageOf(int width, int height, const std::vector<std::array<int, 4>>& codes)
{
    TextureImage image;
    image.width = width;
    image.height = height;
    for (const auto& code : codes)
        for (const int channel : code)
            image.texels.push_back(static_cast<std::byte>(channel));
    return image;
}

TEST(TextureLevels, AreMeansOverTheAreaOfTheirTexels)
{
    // Three texels wide: the only texel of level 1 covers all of them alike (Guthe & Heckbert 2005).
    const TextureImage odd = imageOf(3, 1, {{0, 0, 0, 255}, {51, 0, 0, 255}, {255, 0, 0, 255}});
    EXPECT_NEAR(levelTexel(odd, {TexelContent::data}, 1, 0, 0).r, (0.2 + 1.0) / 3.0, 1e-12);
    // Five wide: the first of two covers two texels and a half.
    const TextureImage five = imageOf(5, 1, {{0, 0, 0, 0}, {255, 0, 0, 0}, {51, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}});
    EXPECT_NEAR(levelTexel(five, {TexelContent::data}, 1, 0, 0).r, (1.0 + 0.5 * 0.2) / 2.5, 1e-12);
}

TEST(TextureLevels, AverageColoursAsLightByTheirAlphaAndNormalsAsDirections)
{
    const TextureImage colors = imageOf(2, 1, {{255, 0, 0, 255}, {0, 255, 0, 51}});
    const dvec4 plain = levelTexel(colors, {TexelContent::color}, 1, 0, 0);
    EXPECT_NEAR(plain.r, 0.5, 1e-12) << "half the light, not half the code";
    const dvec4 weighed = levelTexel(colors, {TexelContent::color, true}, 1, 0, 0);
    EXPECT_NEAR(weighed.r, 1.0 / 1.2, 1e-12) << "premultiplied, divided again";
    EXPECT_NEAR(weighed.a, 0.6, 1e-12);
    // (1, 0, 0)-ish and (0, 1, 0)-ish: the mean direction is between both, unit.
    const TextureImage normals = imageOf(2, 1, {{255, 128, 128, 255}, {128, 255, 128, 255}});
    const dvec3 n = 2.0 * dvec3(levelTexel(normals, {TexelContent::normal}, 1, 0, 0)) - 1.0;
    EXPECT_NEAR(glm::length(n), 1.0, 1e-12);
    EXPECT_NEAR(n.x, n.y, 1e-12);
}

TEST(TextureLevels, AreChosenByTheLongerStepAndBlended)
{
    const TextureImage image = imageOf(4, 4, std::vector<std::array<int, 4>>(16, {0, 0, 0, 255}));
    EXPECT_DOUBLE_EQ(levelOfDetail(image, {dvec2(0.5, 0.0), dvec2(0.0, 0.25)}, 0.0), 1.0) << "two texels";
    EXPECT_DOUBLE_EQ(levelOfDetail(image, {dvec2(0.5, 0.0), dvec2(0.0)}, -0.5), 0.5);
    EXPECT_LT(levelOfDetail(image, {}, 0.0), 0.0);
    EXPECT_LT(levelOfDetail(image, {dvec2(std::nan(""), 0.0), dvec2(0.0)}, 0.0), 0.0);

    const TextureImage step = imageOf(2, 1, {{0, 0, 0, 255}, {255, 0, 0, 255}});
    Sampler sampler;
    sampler.minify = Filter::nearest;
    const auto red = [&](double level) {
        return sampleLevels(step, sampler, {TexelContent::data}, dvec2(0.75, 0.5), level).r;
    };
    EXPECT_DOUBLE_EQ(red(0.25), 0.75 * 1.0 + 0.25 * 0.5);
    EXPECT_DOUBLE_EQ(red(9.0), 0.5) << "the last level";
    sampler.mip = MipFilter::nearest;
    EXPECT_DOUBLE_EQ(red(0.5), 1.0);
    EXPECT_DOUBLE_EQ(red(0.51), 0.5);
    sampler.mip = MipFilter::none;
    EXPECT_DOUBLE_EQ(red(9.0), 1.0);
}

} // namespace
} // namespace torrance
