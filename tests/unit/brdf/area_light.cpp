#include "brdf/area_light.h"
#include "brdf/method.h"

#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

AreaQuery queryOf(const dvec3& toCenter, double radius)
{
    AreaQuery query{.methods = *findPreset("gltf")};
    query.surface = makeShadingPoint(dvec3(0, 0, 1), glm::normalize(dvec3(0.3, -0.4, 0.8)), dvec3(0, 0, 1), 0.4);
    query.surface.baseColor = dvec3(0.7, 0.5, 0.2);
    query.surface.metallic = 0.3;
    query.toCenter = toCenter;
    query.radius = radius;
    query.intensity = dvec3(5, 4, 3);
    return query;
}

TEST(AreaLight, PointFollowsTheInverseSquareAndTheCosine)
{
    // A perfectly black dielectric seen and lit straight on: D = 1/pi, V = 1/4 at roughness 1, F = 0.04.
    AreaQuery query = queryOf(dvec3(0, 0, 2), 0);
    query.surface = makeShadingPoint(dvec3(0, 0, 1), dvec3(0, 0, 1), dvec3(0, 0, 1), 1);
    query.surface.baseColor = dvec3(0);
    EXPECT_NEAR(A_point(query).r, 5.0 / 4.0 * 0.01 / kPi, 1e-15);
    query.toCenter = dvec3(0, 0, -2);
    EXPECT_EQ(A_point(query), dvec3(0)) << "below the horizon";
}

TEST(AreaLight, PointIsFiniteInTheLight)
{
    const dvec3 inside = A_point(queryOf(dvec3(0), 0));
    EXPECT_TRUE(std::isfinite(inside.r) && inside.r > 0);
    EXPECT_NEAR(inside.r / A_point(queryOf(dvec3(0, 0, kLeastLightDistance), 0)).r, 1, 1e-12);
}

} // namespace
} // namespace torrance::brdf
