#include "reference/punctual_light.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

TEST(PunctualLight, PointLightFallsWithTheSquare)
{
    Light light;
    light.kind = Light::Kind::point;
    light.intensity = 12.0;
    light.color = dvec3(1.0, 0.5, 0.25);
    light.position = dvec3(0, 2, 0);
    const LightSample sample = sampleLight(light, dvec3(0, 0, 0), dvec3(0));
    EXPECT_EQ(sample.direction, dvec3(0, 1, 0));
    EXPECT_EQ(sample.irradiance, dvec3(3.0, 1.5, 0.75)) << "candela / metre^2";
    EXPECT_EQ(sampleLight(light, dvec3(0, 1, 0), dvec3(0, -1, 0)).irradiance, sample.irradiance)
        << "origin and offset add";
    EXPECT_EQ(sampleLight(light, dvec3(0), light.position).irradiance, dvec3(0.0)) << "at the light itself";
    const dvec3 nearby = light.position + dvec3(1e-3 * kMinLightDistance, 0, 0);
    EXPECT_NEAR(sampleLight(light, dvec3(0), nearby).irradiance.r, 12.0 / (kMinLightDistance * kMinLightDistance), 1.0);
}

TEST(PunctualLight, RangeIsAWindow)
{
    Light light;
    light.kind = Light::Kind::point;
    light.position = dvec3(0, 2, 0);
    light.range = 4.0;
    // 1 - (2/4)^4 = 15/16, over 4
    EXPECT_DOUBLE_EQ(sampleLight(light, dvec3(0), dvec3(0)).irradiance.r, 15.0 / 64.0);
    light.range = 2.0;
    EXPECT_EQ(sampleLight(light, dvec3(0), dvec3(0)).irradiance.r, 0.0);
}

TEST(PunctualLight, ConeFallsFromInnerToOuter)
{
    Light light;
    light.kind = Light::Kind::spot;
    light.position = dvec3(0, 0, 0);
    light.direction = dvec3(0, 0, -1);
    light.innerConeAngle = 0.2;
    light.outerConeAngle = 0.6;
    const auto at = [&](double angle) {
        return sampleLight(light, dvec3(0), dvec3(std::sin(angle), 0.0, -std::cos(angle))).irradiance.r;
    };
    EXPECT_DOUBLE_EQ(at(0.1), 1.0);
    EXPECT_EQ(at(0.61), 0.0);
    const double share = (std::cos(0.4) - std::cos(0.6)) / (std::cos(0.2) - std::cos(0.6));
    EXPECT_NEAR(at(0.4), share * share, 1e-14);
    light.innerConeAngle = light.outerConeAngle; // a hard edge, kept kLeastConeWidth wide
    EXPECT_DOUBLE_EQ(at(0.5), 1.0);
    EXPECT_EQ(at(0.7), 0.0);
}

TEST(PunctualLight, DirectionalLightIsTheSameEverywhere)
{
    Light light;
    light.intensity = 3.0;
    light.direction = dvec3(0, -1, 0);
    EXPECT_EQ(sampleLight(light, dvec3(1e6), dvec3(5)).irradiance, dvec3(3.0));
    EXPECT_EQ(sampleLight(light, dvec3(0), dvec3(0)).direction, dvec3(0, 1, 0));
}

} // namespace
} // namespace torrance
