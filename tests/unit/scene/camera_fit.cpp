#include "scene/camera_fit.h"
#include "scene/camera_view.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace torrance {
namespace {

constexpr double kRounding = 1e-12; // relative: a few thousand units of double

Scene sceneOfPoints(const std::vector<vec3>& points)
{
    Scene scene;
    Primitive primitive;
    primitive.topology = Topology::points;
    primitive.positions = points;
    for (std::uint32_t i = 0; i < points.size(); ++i)
        primitive.indices.push_back(i);
    scene.primitives.push_back(primitive);
    scene.instances.push_back(Instance{});
    return scene;
}

/// The rectangle of the picture that the vertices cover, in ndc.
struct Extent
{
    dvec2 min = dvec2(std::numeric_limits<double>::infinity());
    dvec2 max = dvec2(-std::numeric_limits<double>::infinity());
    double nearest = std::numeric_limits<double>::infinity();
};

Extent projectedExtent(const Scene& scene, const Camera& camera, double aspect)
{
    const dmat4 clip = projectionMatrix(camera, aspect) * viewFromWorld(camera);
    Extent extent;
    for (const Instance& instance : scene.instances)
        for (const vec3& p : scene.primitives[static_cast<std::size_t>(instance.primitive)].positions) {
            const dvec4 c = clip * instance.worldFromObject * dvec4(dvec3(p), 1.0);
            extent.min = glm::min(extent.min, dvec2(c) / c.w);
            extent.max = glm::max(extent.max, dvec2(c) / c.w);
            extent.nearest = std::min(extent.nearest, c.w);
        }
    return extent;
}

Scene randomScene(std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<vec3> points(3 + random() % 40);
    for (vec3& p : points)
        p = vec3(unit(random), unit(random), unit(random));
    Scene scene = sceneOfPoints(points);
    scene.instances.clear();
    for (int i = 0; i < 3; ++i) {
        Instance instance;
        for (int column = 0; column < 3; ++column)
            instance.worldFromObject[column] = dvec4(unit(random), unit(random), unit(random), 0.0);
        instance.worldFromObject[3] = dvec4(5.0 * unit(random), 5.0 * unit(random), 5.0 * unit(random), 1.0);
        scene.instances.push_back(instance);
    }
    return scene;
}

TEST(OrbitCamera, FrontOfAnAssetIsSeenFromPlusZ)
{
    const dvec3 target(1, 2, 3);
    const auto at = [&](double theta, double phi) {
        return cameraPosition(orbitCamera({theta, phi}, 2.0, target, 0.8)) - target;
    };
    EXPECT_LT(glm::distance(at(0.0, kPi / 2), dvec3(0, 0, 2)), kRounding);
    EXPECT_LT(glm::distance(at(kPi / 2, kPi / 2), dvec3(2, 0, 0)), kRounding) << "theta turns from +Z to +X";
    EXPECT_LT(glm::distance(at(0.0, 0.0), dvec3(0, 2, 0)), kRounding) << "phi is measured from +Y";
    EXPECT_LT(glm::distance(at(kPi, kPi / 2), dvec3(0, 0, -2)), kRounding);
}

TEST(OrbitCamera, LooksAtTheTargetWithUpUpwards)
{
    const Camera camera = orbitCamera({0.7, 1.1}, 3.0, dvec3(4, 5, 6), 0.8);
    const dmat4 view = viewFromWorld(camera);
    EXPECT_LT(glm::distance(dvec3(view * dvec4(4, 5, 6, 1)), dvec3(0, 0, -3)), kRounding);
    const dvec3 up = dmat3(view) * dvec3(0, 1, 0);
    EXPECT_NEAR(up.x, 0.0, kRounding);
    EXPECT_GT(up.y, 0.0);
}

TEST(OrbitCamera, PolesAreTheLimitAlongTheMeridian)
{
    for (const double pole : {0.0, kPi}) {
        const double inside = pole == 0.0 ? 1e-9 : kPi - 1e-9;
        const dmat4 at = orbitCamera({0.3, pole}, 1.0, dvec3(0), 0.8).worldFromCamera;
        const dmat4 beside = orbitCamera({0.3, inside}, 1.0, dvec3(0), 0.8).worldFromCamera;
        for (int c = 0; c < 4; ++c)
            EXPECT_LT(glm::distance(at[c], beside[c]), 1e-8);
    }
}

TEST(OrbitCamera, OtherUpAxes)
{
    const auto position = [](const dvec3& up) {
        return cameraPosition(orbitCamera({0.0, kPi / 2, up}, 1.0, dvec3(0), 0.8));
    };
    EXPECT_LT(glm::distance(position(dvec3(0, 0, 3)), dvec3(0, -1, 0)), kRounding) << "+Z up: the front is -Y";
    EXPECT_LT(glm::distance(position(dvec3(0, -1, 0)), dvec3(0, 0, 1)), kRounding);
    EXPECT_LT(glm::distance(position(dvec3(0, 0, 0)), dvec3(0, 0, 1)), kRounding) << "no direction counts as +Y";
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 100; ++i) {
        const dvec3 up = glm::normalize(dvec3(unit(random), unit(random), unit(random)));
        const dmat3 m(orbitCamera({unit(random), 0.0, up}, 1.0, dvec3(0), 0.8).worldFromCamera);
        EXPECT_LT(glm::distance(m[2], up), kRounding) << "phi = 0 looks down from `up`";
        EXPECT_NEAR(glm::determinant(m), 1.0, kRounding);
        EXPECT_NEAR(glm::dot(m[0], m[1]), 0.0, kRounding);
    }
}

TEST(FitCamera, EveryVertexInsideAndTheMarginTouched)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int trial = 0; trial < 300; ++trial) {
        const Scene scene = randomScene(random);
        const double aspect = 0.3 + 3.0 * unit(random);
        const double margin = 0.5 * unit(random);
        const double fov = 0.1 + 2.0 * unit(random);
        const OrbitAngles angles{7.0 * unit(random), 3.14 * unit(random),
                                 dvec3(unit(random), unit(random), -unit(random))};
        const Camera camera = fitCamera(scene, angles, aspect, fov, margin);
        const Extent e = projectedExtent(scene, camera, aspect);
        const double limit = 1.0 - margin;
        const double slack = kRounding * 1e3; // projection divides by distances that cancel
        EXPECT_LE(std::max(e.max.x, e.max.y), limit + slack) << "trial " << trial;
        EXPECT_GE(std::min(e.min.x, e.min.y), -limit - slack) << "trial " << trial;
        EXPECT_NEAR(e.min.x + e.max.x, 0.0, slack) << "centred, trial " << trial;
        EXPECT_NEAR(e.min.y + e.max.y, 0.0, slack) << "centred, trial " << trial;
        const dvec3 size = worldBounds(scene).max - worldBounds(scene).min;
        if (e.nearest > 1.001 * kLeastClearance * glm::length(size)) {
            EXPECT_NEAR(std::max(e.max.x, e.max.y), limit, slack) << "touches, trial " << trial;
        }
        EXPECT_GT(e.nearest, camera.nearPlane);
        EXPECT_GT(camera.nearPlane, 0.0);
    }
}

TEST(FitCamera, SphereTouchesByItsSilhouette)
{
    // A ball of radius 1 fills a square picture when the sine of half the field of view is 1 / distance.
    Scene scene;
    scene.shapes.push_back(AnalyticShape{});
    scene.shapes.back().worldFromObject[3] = dvec4(3, -2, 8, 1);
    const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.9, 0.0);
    EXPECT_NEAR(glm::distance(cameraPosition(camera), dvec3(3, -2, 8)), 1.0 / std::sin(0.45), 1e-9);
}

TEST(FitCamera, PlaneIsItsCorners)
{
    Scene scene;
    scene.shapes.push_back(AnalyticShape{.kind = AnalyticShape::Kind::plane, .material = -1, .name = {}});
    const Camera camera = fitCamera(scene, {}, 1.0, kPi / 2, 0.0);
    EXPECT_LT(glm::distance(cameraPosition(camera), dvec3(0, 0, 1)), kRounding);
}

TEST(FitCamera, DegenerateScenesGiveAFiniteCamera)
{
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::vector<vec3>> cases = {
        {},
        {vec3(0)},
        {vec3(1e6f, -2e6f, 3e6f)},
        {vec3(kNan)},
        {vec3(kNan), vec3(0), vec3(1)},
        {vec3(0, 0, -1), vec3(0, 0, 1)},                          // a needle on the line of sight
        {vec3(-1, 0, 0), vec3(1, 0, 0)},                          // a needle across it
        {vec3(0), vec3(1e-30f, 0, 0)},                            // smaller than anything
        {vec3(-3e38f), vec3(3e38f)},                              // larger than anything
        {vec3(-1e-3f, 0, -1), vec3(1e-3f, 0, -1), vec3(0, 0, 1)}, // a spike towards the eye
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Camera camera = fitCamera(sceneOfPoints(cases[i]), {}, 1.5, 0.8, 0.1);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r)
                EXPECT_TRUE(std::isfinite(camera.worldFromCamera[c][r])) << "case " << i;
        EXPECT_GT(camera.nearPlane, 0.0) << "case " << i;
        EXPECT_TRUE(std::isfinite(camera.nearPlane)) << "case " << i;
    }
    EXPECT_TRUE(worldBounds(Scene{}).empty);
    EXPECT_NEAR(glm::length(cameraPosition(fitCamera(Scene{}, {}, 1.0, 0.8, 0.0))), kPointExtent / std::sin(0.4), 1e-9)
        << "an empty scene is a ball about the origin";
}

TEST(FitCamera, IgnoresVerticesThatNoIndexNames)
{
    Scene scene = sceneOfPoints({vec3(-1, 0, 0), vec3(1, 0, 0), vec3(1000, 0, 0)});
    scene.primitives[0].indices = {0, 1};
    EXPECT_EQ(worldBounds(scene).max.x, 1.0);
}

TEST(FitNearPlane, HalfWayToTheSceneAndNeverZero)
{
    Scene scene;
    scene.shapes.push_back(AnalyticShape{});
    const Camera outside = fitNearPlane(orbitCamera({}, 5.0, dvec3(0), 0.8), scene);
    EXPECT_NEAR(outside.nearPlane, 2.0, kRounding) << "the bounds begin 4 away";
    const Camera inside = fitNearPlane(orbitCamera({}, 0.5, dvec3(0), 0.8), scene);
    EXPECT_NEAR(inside.nearPlane, kLeastNear * std::sqrt(12.0), kRounding);
    EXPECT_GT(fitNearPlane(Camera{}, Scene{}).nearPlane, 0.0);
}

} // namespace
} // namespace torrance
