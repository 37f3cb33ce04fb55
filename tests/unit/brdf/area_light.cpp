#include "brdf/area_light.h"
#include "brdf/brdf.h"
#include "brdf/method.h"
#include "math/frame.h"
#include "math/quadrature.h"

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

// The same light by another parametrisation: over the sphere's own surface instead of over directions.
dvec3 overTheSurface(const AreaQuery& query)
{
    static const QuadratureRule rule = gaussLegendre(200, -1.0, 1.0);
    constexpr int kAround = 400;
    const dvec3 radiance = query.intensity / (kPi * query.radius * query.radius);
    const dmat3 axes = frameAround(glm::normalize(query.toCenter));
    dvec3 sum(0);
    for (std::size_t i = 0; i < rule.size(); ++i)
        for (int j = 0; j < kAround; ++j) {
            const double z = rule.nodes[i], s = std::sqrt(1 - z * z), phi = 2 * kPi * (j + 0.5) / kAround;
            const dvec3 m = axes * dvec3(s * std::cos(phi), s * std::sin(phi), z);
            const dvec3 p = query.toCenter + query.radius * m;
            const double facing = -glm::dot(m, p) / glm::length(p);
            if (facing <= 0)
                continue;
            ShadingPoint point =
                makeShadingPoint(query.surface.n, query.surface.v, p, query.surface.perceptualRoughness);
            point.baseColor = query.surface.baseColor;
            point.metallic = query.surface.metallic;
            const double area = rule.weights[i] * 2 * kPi / kAround * query.radius * query.radius;
            sum += evaluateTerms(query.methods, point).response() * radiance * (facing * area / glm::dot(p, p));
        }
    return sum;
}

// Above the horizon and cut by it. 2^16 Hammersley points leave some 1e-4; the surface's grid has the visible rim in
// it.
TEST(AreaLight, SamplesOfTheConeMeetTheSurfacesIntegral)
{
    for (const dvec3& center : {dvec3(0.5, 0.2, 1.5), dvec3(1.2, 0.0, 0.1), dvec3(0.8, -0.5, -0.2)}) {
        AreaQuery query = queryOf(center, 0.6);
        query.samples = 1 << 16;
        const dvec3 exact = overTheSurface(query);
        EXPECT_LE(glm::length(A_sampled(query) - exact), 5e-3 * glm::length(exact)) << center.x << ' ' << center.z;
    }
}

TEST(AreaLight, AVanishingRadiusIsThePoint)
{
    AreaQuery query = queryOf(dvec3(0.5, 0.2, 1.5), 1e-8);
    query.samples = 16;
    const dvec3 point = A_point(query);
    EXPECT_LE(glm::length(A_sampled(query) / point - dvec3(1)), 1e-6);
    EXPECT_LE(glm::length(A_representative(query) / point - dvec3(1)), 1e-6);
}

// The light fills the hemisphere as soon as the point is on it: nothing jumps there, and nothing within is not finite.
TEST(AreaLight, IsContinuousAtTheSphereAndFiniteInIt)
{
    for (const auto formula : {&A_sampled, &A_representative}) {
        AreaQuery query = queryOf(dvec3(0.2, 0.1, 1.0), 0);
        query.samples = 1024;
        const double distance = glm::length(query.toCenter);
        query.radius = distance * (1 - 1e-7);
        const dvec3 outside = formula(query);
        query.radius = distance * (1 + 1e-7);
        EXPECT_LE(glm::length(formula(query) / outside - dvec3(1)), 5e-3) << "sin of the cone is within 1e-7 of 1";
        query.radius = 10;
        EXPECT_TRUE(std::isfinite(formula(query).r) && formula(query).r > 0);
    }
}

} // namespace
} // namespace torrance::brdf
