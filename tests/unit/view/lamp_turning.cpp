#include "view/lamp_turning.h"

#include <array>
#include <gtest/gtest.h>

namespace torrance {
namespace {

Light lightOf(const dvec3& position, const dvec3& direction)
{
    Light light;
    light.position = position;
    light.direction = direction;
    return light;
}

void expectNear(const dvec3& a, const dvec3& b)
{
    EXPECT_LT(glm::length(a - b), 1e-12);
}

TEST(LampTurning, QuarterTurnTakesFrontToTheRight)
{
    // Counter-clockwise seen from above, +Y towards the eye: +Z goes to +X.
    std::array lights = {lightOf({1.0, 5.0, 4.0}, {0.0, 0.0, -1.0})};
    turnLights(lights, dvec3(1.0, 0.0, 1.0), 90.0);
    expectNear(lights[0].position, {4.0, 5.0, 1.0});
    expectNear(lights[0].direction, {-1.0, 0.0, 0.0});
}

TEST(LampTurning, AWholeTurnInStepsEndsWhereItBegan)
{
    std::array lights = {lightOf({3.0, -2.0, 7.0}, {0.6, -0.8, 0.0})};
    for (int i = 0; i < 360; ++i)
        turnLights(lights, dvec3(0.5, 0.0, -0.25), 1.0);
    expectNear(lights[0].position, {3.0, -2.0, 7.0});
    expectNear(lights[0].direction, {0.6, -0.8, 0.0});
}

} // namespace
} // namespace torrance
