#include "view/view_point.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

TEST(ViewPoint, TheWholeSceneIsSeenFromWhereItIsSeenNow)
{
    const FittedView fitted = wholeSceneFrom(FittedView{12.0, 34.0});
    EXPECT_EQ(fitted.theta, 12.0);
    EXPECT_EQ(fitted.phi, 34.0);
    const FittedView free = wholeSceneFrom(OrbitPose{.theta = -100.0, .phi = 60.0});
    EXPECT_EQ(free.theta, -100.0);
    EXPECT_EQ(free.phi, 60.0);
}

TEST(ViewPoint, AnglesAboutAnotherAxisAreNoDirectionOfTheScene)
{
    for (const ViewPoint& view : {ViewPoint(FileView{1}), ViewPoint(OrbitPose{.theta = 5.0, .up = {0.0, 0.0, 1.0}})}) {
        EXPECT_EQ(wholeSceneFrom(view).theta, kDefaultTheta);
        EXPECT_EQ(wholeSceneFrom(view).phi, kDefaultPhi);
    }
}

} // namespace
} // namespace torrance
