#include "view/selection_box.h"

#include "scene/camera_fit.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

Scene boxOfHalfSize(double half)
{
    Scene scene;
    Primitive box;
    box.boundsMin = dvec3(-half);
    box.boundsMax = dvec3(half);
    scene.primitives.push_back(box);
    scene.instances.push_back({});
    return scene;
}

Camera fromZ(double distance)
{
    Camera camera = lookAtCamera(dvec3(0.0, 0.0, distance), dvec3(0.0), dvec3(0.0, 1.0, 0.0), kPi / 2.0);
    camera.nearPlane = 0.1;
    return camera;
}

TEST(SelectionBox, LiesWhereTheCameraSeesTheCorners)
{
    const auto lines = selectionBox(boxOfHalfSize(1.0), 0, fromZ(3.0), {400, 200});
    ASSERT_EQ(lines.size(), 12u);
    // The front is at distance 2 with tan(45 degrees) = 1 half a height: 100 / 2 pixels from the middle.
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const ScreenLine& line : lines)
        for (const dvec2& end : {line.begin, line.end}) {
            left = std::min(left, end.x);
            right = std::max(right, end.x);
            top = std::min(top, end.y);
            bottom = std::max(bottom, end.y);
        }
    EXPECT_NEAR(left, 150.0, 1e-9);
    EXPECT_NEAR(right, 250.0, 1e-9);
    EXPECT_NEAR(top, 50.0, 1e-9);
    EXPECT_NEAR(bottom, 150.0, 1e-9);
}

TEST(SelectionBox, IsCutOffAtTheNearPlane)
{
    // The camera stands inside: the four edges of the back are whole, the four beside it are cut, the front is not
    // seen.
    const auto lines = selectionBox(boxOfHalfSize(1.0), 0, fromZ(0.0), {200, 200});
    EXPECT_EQ(lines.size(), 8u);
    for (const ScreenLine& line : lines)
        for (const dvec2& end : {line.begin, line.end})
            EXPECT_TRUE(std::isfinite(end.x) && std::isfinite(end.y));
}

TEST(SelectionBox, IsNotSeenBehindTheCamera)
{
    Camera away = lookAtCamera(dvec3(0.0, 0.0, 3.0), dvec3(0.0, 0.0, 6.0), dvec3(0.0, 1.0, 0.0), 1.0);
    away.nearPlane = 0.1;
    EXPECT_TRUE(selectionBox(boxOfHalfSize(1.0), 0, away, {200, 200}).empty());
}

} // namespace
} // namespace torrance
