#include "view/screen_place.h"

#include "scene/camera_fit.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

Camera fromZ()
{
    Camera camera = lookAtCamera(dvec3(0.0, 0.0, 4.0), dvec3(0.0), dvec3(0.0, 1.0, 0.0), kPi / 2.0);
    camera.nearPlane = 0.1;
    return camera;
}

TEST(ScreenPlace, IsWhereThePictureShowsAPoint)
{
    const auto pixel = pixelOfPoint(dvec3(1.0, 2.0, 0.0), fromZ(), {300, 200});
    ASSERT_TRUE(pixel); // at distance 4 half a height is 4: 25 pixels a metre
    EXPECT_NEAR(pixel->x, 150.0 + 25.0, 1e-9);
    EXPECT_NEAR(pixel->y, 100.0 - 50.0, 1e-9);
    EXPECT_FALSE(pixelOfPoint(dvec3(0.0, 0.0, 5.0), fromZ(), {300, 200}));
    EXPECT_FALSE(pixelOfPoint(dvec3(0.0, 0.0, 3.95), fromZ(), {300, 200}));
}

TEST(ScreenPlace, MovesAPointAtItsDepth)
{
    const dvec3 start(0.5, -0.25, 1.5);
    const dvec3 end = movedByPixels(start, {30.0, -12.0}, fromZ(), {300, 200});
    EXPECT_NEAR(end.z, start.z, 1e-9);
    const auto before = pixelOfPoint(start, fromZ(), {300, 200}), after = pixelOfPoint(end, fromZ(), {300, 200});
    EXPECT_NEAR(after->x - before->x, 30.0, 1e-9);
    EXPECT_NEAR(after->y - before->y, -12.0, 1e-9);
}

TEST(ScreenPlace, MovesAPointBeforeAnOrthographicCamera)
{
    Camera camera = fromZ();
    camera.kind = Camera::Kind::orthographic;
    camera.xmag = 3.0;
    camera.ymag = 2.0;
    camera.farPlane = 10.0;
    const dvec3 end = movedByPixels(dvec3(0.0), {50.0, 0.0}, camera, {300, 200}); // 50 pixels a metre
    EXPECT_NEAR(end.x, 1.0, 1e-9);
    EXPECT_NEAR(end.z, 0.0, 1e-9);
}

} // namespace
} // namespace torrance
