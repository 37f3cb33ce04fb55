#include "scene/pixel_box.h"

#include "scene/camera_fit.h"
#include "scene/camera_view.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace torrance {
namespace {

constexpr int kWidth = 320, kHeight = 200;

Camera camera(Camera::Kind kind)
{
    Camera c = orbitCamera({0.4, 1.1}, 6.0, dvec3(0.0), 0.7);
    c.kind = kind;
    c.ymag = 2.0;
    c.nearPlane = 0.5;
    c.farPlane = 50.0;
    return c;
}

/// Where a point of the world is drawn, in pixels from the upper left corner.
dvec2 pixelOf(const Camera& c, const dvec3& p)
{
    const dvec4 clip = projectionMatrix(c, double(kWidth) / kHeight) * viewFromWorld(c) * dvec4(p, 1.0);
    return (dvec2(clip) / clip.w * 0.5 + 0.5) * dvec2(kWidth, kHeight);
}

TEST(PixelBox, HoldsEveryPointOfTheBox)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const auto kind : {Camera::Kind::perspective, Camera::Kind::orthographic})
        for (int i = 0; i < 200; ++i) {
            const auto point = [&] { return 3.0 * dvec3(unit(random), unit(random), unit(random)) - 1.5; };
            Box box;
            box.include(point());
            box.include(point());
            const Camera c = camera(kind);
            const PixelBox seen = pixelBoxOf(c, kWidth, kHeight, box);
            EXPECT_FALSE(seen.nearCut);
            for (int k = 0; k < 20; ++k) {
                const dvec3 inside = glm::mix(box.least, box.greatest, dvec3(unit(random), unit(random), unit(random)));
                const dvec2 pixel = pixelOf(c, inside);
                if (pixel.x < 0.0 || pixel.y < 0.0 || pixel.x >= kWidth || pixel.y >= kHeight)
                    continue;
                EXPECT_TRUE(pixel.x >= seen.first.x && pixel.x < seen.beyond.x && pixel.y >= seen.first.y &&
                            pixel.y < seen.beyond.y);
            }
        }
}

TEST(PixelBox, BlocksAreWholeAndOnceEach)
{
    const std::array pixels = {ivec2(5, 9), ivec2(4, 8), ivec2(318, 199), ivec2(0, 0)};
    const std::vector<PixelBox> blocks = blocksAround(pixels, 319, 200);
    ASSERT_EQ(blocks.size(), 3u);
    EXPECT_EQ(blocks[0].first, ivec2(0, 0));
    EXPECT_EQ(blocks[0].beyond, ivec2(kShadedBlock));
    EXPECT_EQ(blocks[1].first, ivec2(4, 8));
    EXPECT_EQ(blocks[1].beyond, ivec2(8, 12));
    EXPECT_EQ(blocks[2].first, ivec2(316, 196));
    EXPECT_EQ(blocks[2].beyond, ivec2(319, 200)) << "no further than the picture";
}

// A small box covers little more than itself: its corners and a pixel round them.
TEST(PixelBox, IsNoLargerThanItMustBe)
{
    const Camera c = camera(Camera::Kind::perspective);
    Box box;
    box.include(dvec3(-0.1));
    box.include(dvec3(0.1));
    dvec2 least(1e9), greatest(-1e9);
    for (int i = 0; i < 8; ++i) {
        least = glm::min(least, pixelOf(c, box.corner(i)));
        greatest = glm::max(greatest, pixelOf(c, box.corner(i)));
    }
    const PixelBox seen = pixelBoxOf(c, kWidth, kHeight, box);
    EXPECT_GE(seen.first.x, least.x - 2.0);
    EXPECT_GE(seen.first.y, least.y - 2.0);
    EXPECT_LE(seen.beyond.x, greatest.x + 2.0);
    EXPECT_LE(seen.beyond.y, greatest.y + 2.0);
}

TEST(PixelBox, IsEmptyBesideThePictureAndForNothing)
{
    const Camera c = camera(Camera::Kind::perspective);
    EXPECT_TRUE(pixelBoxOf(c, kWidth, kHeight, Box{}).empty());
    const dmat4 world = glm::inverse(viewFromWorld(c));
    Box aside;
    aside.include(dvec3(world * dvec4(40.0, 0.0, -6.0, 1.0)));
    EXPECT_TRUE(pixelBoxOf(c, kWidth, kHeight, aside).empty());
}

TEST(PixelBox, IsThePictureWhereTheBoxReachesBehindTheNearPlane)
{
    const Camera c = camera(Camera::Kind::perspective);
    Box box;
    box.include(cameraPosition(c));
    box.include(dvec3(0.0));
    const PixelBox seen = pixelBoxOf(c, kWidth, kHeight, box);
    EXPECT_TRUE(seen.nearCut);
    EXPECT_EQ(seen.first, ivec2(0));
    EXPECT_EQ(seen.beyond, ivec2(kWidth, kHeight));
}

TEST(PixelBox, JoinsOthers)
{
    PixelBox box;
    box.include({.first = {3, 4}, .beyond = {5, 6}});
    box.include({});
    box.include({.first = {1, 5}, .beyond = {2, 9}, .nearCut = true});
    EXPECT_EQ(box.first, ivec2(1, 4));
    EXPECT_EQ(box.beyond, ivec2(5, 9));
    EXPECT_TRUE(box.nearCut);
}

} // namespace
} // namespace torrance
