#include "view/orbit_pose.h"

#include "scene/camera_view.h"

#include <gtest/gtest.h>
#include <random>

namespace torrance {
namespace {

void expectNear(const dvec3& a, const dvec3& b, double tolerance)
{
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], tolerance);
}

dvec3 forwardOf(const Camera& camera)
{
    const dmat4 view = viewFromWorld(camera);
    return -dvec3(view[0].z, view[1].z, view[2].z);
}

Scene unitScene()
{
    Scene scene;
    scene.shapes.push_back({});
    return scene;
}

TEST(OrbitPose, IsReadBackFromItsCamera)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        OrbitPose pose = {.theta = 360.0 * share(random) - 180.0,
                          .phi = 1.0 + 178.0 * share(random),
                          .radius = 0.1 + 10.0 * share(random),
                          .target = dvec3(share(random), share(random), share(random)),
                          .verticalFov = 20.0 + 60.0 * share(random)};
        if (i % 2)
            pose.up = glm::normalize(dvec3(share(random), share(random), share(random)));
        const Camera camera = cameraOf(pose, unitScene());
        const OrbitPose again = poseOf(camera, pose.target);
        EXPECT_NEAR(again.radius, pose.radius, 1e-12 * pose.radius);
        expectNear(again.target, pose.target, 1e-11);
        const Camera same = cameraOf(again, unitScene());
        expectNear(cameraPosition(same), cameraPosition(camera), 1e-11);
        for (int column = 0; column < 3; ++column)
            expectNear(dvec3(viewFromWorld(same)[column]), dvec3(viewFromWorld(camera)[column]), 1e-9);
    }
}

TEST(OrbitPose, LooksAtThePivotsDepthFromACameraOfAFile)
{
    Camera camera = lookAtCamera(dvec3(3.0, 4.0, 5.0), dvec3(0.0, 1.0, 0.0), dvec3(0.0, 1.0, 0.0), 0.7);
    const OrbitPose pose = poseOf(camera, dvec3(0.0));
    // The point of the line of sight nearest to the origin.
    EXPECT_NEAR(glm::dot(pose.target, forwardOf(camera)), 0.0, 1e-12);
    EXPECT_NEAR(pose.verticalFov, 0.7 * 180.0 / kPi, 1e-12);
}

TEST(OrbitPose, TakesAnOrthographicCameraForThePerspectiveOneThatSeesAsMuch)
{
    Camera camera = lookAtCamera(dvec3(0.0, 0.0, 4.0), dvec3(0.0), dvec3(0.0, 1.0, 0.0), 0.7);
    camera.kind = Camera::Kind::orthographic;
    camera.ymag = 2.0;
    const OrbitPose pose = poseOf(camera, dvec3(0.0));
    EXPECT_NEAR(pose.radius * std::tan(0.5 * pose.verticalFov * kPi / 180.0), 2.0, 1e-12);
}

TEST(OrbitPose, TurnsAboutItsTargetAndStopsAtThePoles)
{
    OrbitPose pose;
    orbit(pose, 350.0, 0.0);
    EXPECT_NEAR(pose.theta, 20.0, 1e-12);
    orbit(pose, 0.0, -500.0);
    EXPECT_EQ(pose.phi, 0.0);
    expectNear(forwardOf(cameraOf(pose, unitScene())), dvec3(0.0, -1.0, 0.0), 1e-12);
    orbit(pose, 0.0, 500.0);
    EXPECT_EQ(pose.phi, 180.0);
    EXPECT_EQ(pose.radius, OrbitPose().radius);
}

TEST(OrbitPose, PansByPartsOfThePicturesHeight)
{
    OrbitPose pose = {.theta = 0.0, .phi = 90.0, .radius = 2.0, .verticalFov = 90.0};
    pan(pose, 0.25, 0.5); // the picture is 4 high at the target
    expectNear(pose.target, dvec3(1.0, 2.0, 0.0), 1e-12);
}

TEST(OrbitPose, KeepsItsDistanceWithinTheScenesScale)
{
    OrbitPose pose;
    dolly(pose, 1e-30, 3.0);
    EXPECT_EQ(pose.radius, kNearestRadius * 3.0);
    dolly(pose, 1e30, 3.0);
    EXPECT_EQ(pose.radius, kFarthestRadius * 3.0);
}

TEST(OrbitPose, FliesAlongItsLineOfSight)
{
    OrbitPose pose = {.theta = 90.0, .phi = 90.0, .radius = 2.0}; // looks along -X
    fly(pose, 0.5, 0.0);
    expectNear(pose.target, dvec3(-1.0, 0.0, 0.0), 1e-12);
    fly(pose, 0.0, 0.5);
    expectNear(pose.target, dvec3(-1.0, 0.0, -1.0), 1e-12);
}

TEST(OrbitPose, LooksAtAnotherPointFromWhereItStands)
{
    OrbitPose pose;
    const dvec3 eye = cameraPosition(cameraOf(pose, unitScene()));
    lookAt(pose, dvec3(0.3, -0.2, 0.1));
    expectNear(cameraPosition(cameraOf(pose, unitScene())), eye, 1e-12);
    expectNear(pose.target, dvec3(0.3, -0.2, 0.1), 0.0);
}

TEST(OrbitPose, SaysItsNumbersSoThatTheyAreReadBackToTheBit)
{
    const OrbitPose pose = {.theta = 100.0 / 3.0, .phi = 0.1, .radius = 1e-7, .target = dvec3(1.0 / 3.0, 0.0, -2e10)};
    const std::vector<std::string> arguments = cameraArguments(pose);
    EXPECT_EQ(arguments[0], "--orbit=33.333333333333336,0.1,1e-07");
    EXPECT_EQ(arguments[1], "--target=0.3333333333333333,0,-20000000000");
    EXPECT_EQ(arguments.size(), 3u); // +Y is up unless another is
}

} // namespace
} // namespace torrance
