#include "view/camera_steps.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

constexpr double kDiagonal = 3.0, kRounding = 1e-12;

OrbitPose somePose()
{
    return {.theta = 20.0, .phi = 70.0, .radius = 2.0, .target = dvec3(0.5, 1.0, -0.25)};
}

OrbitPose after(const std::vector<dvec2>& scrolls, bool across = false)
{
    OrbitPose pose = somePose();
    for (const dvec2& steps : scrolls)
        scroll(pose, steps, across, kDiagonal);
    return pose;
}

void expectSame(const OrbitPose& a, const OrbitPose& b)
{
    EXPECT_NEAR(a.theta, b.theta, kRounding * 180.0);
    EXPECT_NEAR(a.phi, b.phi, kRounding * 180.0);
    EXPECT_NEAR(a.radius, b.radius, kRounding);
    EXPECT_NEAR(glm::length(a.target - b.target), 0.0, kRounding);
}

// A trackpad's many small ways are a wheel's few large ones.
TEST(CameraSteps, FractionsOfAStepAddUp)
{
    for (const bool across : {false, true})
        for (const dvec2 step : {dvec2(0.0, 1.0), dvec2(0.0, -1.0), dvec2(1.0, 0.0), dvec2(-1.0, 0.0)}) {
            expectSame(after({0.25 * step, 0.125 * step, 0.5 * step, 0.125 * step}, across), after({step}, across));
            expectSame(after({0.3 * step, -0.3 * step}, across), somePose());
        }
}

TEST(CameraSteps, AWheelGoesNearerAndFarther)
{
    EXPECT_DOUBLE_EQ(after({{0.0, 1.0}}).radius, 2.0 / kDollyStep);
    EXPECT_DOUBLE_EQ(after({{0.0, -1.0}}).radius, 2.0 * kDollyStep);
    EXPECT_DOUBLE_EQ(after({{0.0, 0.5}}).radius, 2.0 / std::sqrt(kDollyStep));
}

TEST(CameraSteps, AWheelAsideTurnsAboutTheTarget)
{
    EXPECT_DOUBLE_EQ(after({{1.0, 0.0}}).theta, 20.0 - kTurnStep) << "to the left, as the key with that arrow";
    EXPECT_DOUBLE_EQ(after({{-0.5, 0.0}}).theta, 20.0 + 0.5 * kTurnStep);
    EXPECT_EQ(after({{1.0, 0.0}}).radius, 2.0);
}

TEST(CameraSteps, OfTwoWaysTheLongerCounts)
{
    expectSame(after({{0.2, 0.9}}), after({{0.0, 0.9}}));
    expectSame(after({{-0.9, 0.2}}), after({{-0.9, 0.0}}));
}

TEST(CameraSteps, AcrossBothWaysCount)
{
    OrbitPose moved = somePose();
    pan(moved, -kAcrossStep * 0.5, kAcrossStep * 0.25);
    expectSame(after({{0.5, 0.25}}, true), moved);
}

TEST(CameraSteps, NothingDoesNothing)
{
    expectSame(after({{0.0, 0.0}}), somePose());
    expectSame(after({{0.0, 0.0}}, true), somePose());
}

} // namespace
} // namespace torrance
