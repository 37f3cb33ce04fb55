#include "scene/constant_light.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

// Source A: radiance intensity / d^2, from the same side everywhere.
TEST(ConstantLight, IsDirectionalLightOfIntensityOverSquaredDistance)
{
    const Light light = constantLight(dvec3(0.0, 3.0, 4.0), 2.0, 30.0);
    EXPECT_EQ(light.kind, Light::Kind::directional);
    EXPECT_NEAR(light.intensity, 7.5, 1e-15);
    EXPECT_NEAR(glm::length(light.direction - dvec3(0.0, -0.6, -0.8)), 0.0, 1e-15) << "the way it travels";
}

} // namespace
} // namespace torrance
