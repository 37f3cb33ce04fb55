#include "view/panorama_thumbnails.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

TEST(PanoramaThumbnails, WhatIsEverywhereAlikeIsMiddleGrey)
{
    const std::vector<std::uint8_t> codes = panoramaCodes(Image(64, 32, 3, 250.0f), 16);
    ASSERT_EQ(codes.size(), 16u * 8u * 4u);
    const double grey = 1.055 * std::pow(0.18, 1.0 / 2.4) - 0.055; // IEC 61966-2-1
    for (std::size_t i = 0; i < codes.size(); ++i)
        EXPECT_EQ(codes[i], i % 4 == 3 ? 255 : std::lround(255.0 * grey));
}

TEST(PanoramaThumbnails, MeansKeepTheirPlacesAndASunIsWhite)
{
    Image radiance(64, 32, 3, 1.0f);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            radiance.at(x + 8, y + 12)[0] = (x + y) % 2 ? 0.0f : 2e4f; // red, half of the texels
    const std::vector<std::uint8_t> codes = panoramaCodes(radiance, 16);
    const std::uint8_t* sun = codes.data() + 4 * (3 * 16 + 2);
    EXPECT_EQ(sun[0], 255);
    EXPECT_EQ(sun[1], codes[1]);
    EXPECT_NE(codes[0], 255);
}

TEST(PanoramaThumbnails, OneSmallerThanItsPictureIsEnlarged)
{
    Image radiance(2, 1, 3, 1.0f);
    radiance.at(1, 0)[2] = 0.0f;
    const std::vector<std::uint8_t> codes = panoramaCodes(radiance, 16);
    EXPECT_NE(codes[2], 0);
    EXPECT_EQ(codes[4 * 15 + 2], 0);
}

} // namespace
} // namespace torrance
