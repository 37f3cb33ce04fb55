#include "scene/camera_view.h"

#include "scene/camera_fit.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

constexpr double kRounding = 1e-12;

dvec3 ndcOf(const Camera& camera, double aspect, const dvec3& viewPoint)
{
    const dvec4 clip = projectionMatrix(camera, aspect) * dvec4(viewPoint, 1.0);
    return dvec3(clip) / clip.w;
}

TEST(Projection, DepthIsOneNearAndZeroFar)
{
    Camera camera;
    camera.nearPlane = 0.25;
    EXPECT_NEAR(ndcOf(camera, 1.5, dvec3(0, 0, -0.25)).z, 1.0, kRounding);
    EXPECT_NEAR(ndcOf(camera, 1.5, dvec3(0, 0, -2.5)).z, 0.1, kRounding) << "near / distance";
    EXPECT_NEAR(ndcOf(camera, 1.5, dvec3(0, 0, -1e30)).z, 0.0, kRounding);
    camera.farPlane = 8.0;
    EXPECT_NEAR(ndcOf(camera, 1.5, dvec3(0, 0, -0.25)).z, 1.0, kRounding);
    EXPECT_NEAR(ndcOf(camera, 1.5, dvec3(0, 0, -8.0)).z, 0.0, kRounding);
    camera.kind = Camera::Kind::orthographic;
    EXPECT_NEAR(ndcOf(camera, 1.5, dvec3(0, 0, -0.25)).z, 1.0, kRounding);
    EXPECT_NEAR(ndcOf(camera, 1.5, dvec3(0, 0, -8.0)).z, 0.0, kRounding);
}

TEST(Projection, KeepsTheVerticalExtentAndPointsDown)
{
    Camera camera;
    camera.verticalFov = kPi / 2;
    camera.aspect = 1.0; // of the file; the picture's is 2
    const dvec3 corner = ndcOf(camera, 2.0, dvec3(2, 1, -1));
    EXPECT_NEAR(corner.x, 1.0, kRounding);
    EXPECT_NEAR(corner.y, -1.0, kRounding) << "up is -y in Vulkan's clip space";
    camera.kind = Camera::Kind::orthographic;
    camera.ymag = 3.0;
    camera.farPlane = 10.0;
    EXPECT_NEAR(ndcOf(camera, 2.0, dvec3(6, 3, -1)).x, 1.0, kRounding);
    EXPECT_NEAR(ndcOf(camera, 2.0, dvec3(6, 3, -1)).y, -1.0, kRounding);
}

/// A ray and the matrices are two writings of one camera: a point on the ray projects to the pixel it was made for.
TEST(PrimaryRay, AgreesWithTheMatrices)
{
    for (const Camera::Kind kind : {Camera::Kind::perspective, Camera::Kind::orthographic}) {
        Camera camera = orbitCamera({0.5, 1.2, dvec3(0.1, 1, 0.2)}, 3.0, dvec3(1e3, 2, 3), 0.7);
        camera.kind = kind;
        camera.farPlane = 100.0;
        camera.ymag = 2.0;
        const dmat4 clip = projectionMatrix(camera, 320.0 / 200.0) * viewFromWorld(camera);
        for (const dvec2 pixel : {dvec2(0.5, 0.5), dvec2(319.5, 199.5), dvec2(17.25, 150.0), dvec2(160.0, 100.0)}) {
            const Ray ray = primaryRay(camera, 320, 200, pixel.x, pixel.y);
            const dvec4 c = clip * dvec4(cameraPosition(camera) + ray.origin + 7.0 * ray.direction, 1.0);
            EXPECT_NEAR((c.x / c.w * 0.5 + 0.5) * 320.0, pixel.x, 1e-9);
            EXPECT_NEAR((c.y / c.w * 0.5 + 0.5) * 200.0, pixel.y, 1e-9);
            EXPECT_NEAR(glm::length(ray.direction), 1.0, kRounding);
        }
    }
}

TEST(View, TakesNoScaleFromTheCamera)
{
    Camera camera;
    camera.worldFromCamera = dmat4(dvec4(2, 0, 0, 0), dvec4(0, 3, 0, 0), dvec4(0, 0, 4, 0), dvec4(1, 2, 3, 1));
    EXPECT_LT(glm::distance(dvec3(viewFromWorld(camera) * dvec4(2, 3, 4, 1)), dvec3(1)), kRounding);
    camera.worldFromCamera = dmat4(0.0);
    const dmat3 rotation(viewFromWorld(camera));
    EXPECT_NEAR(glm::determinant(rotation), 1.0, kRounding) << "a singular matrix still gives a rotation";
}

TEST(LookAt, PlacesTheTargetInTheCentre)
{
    const Camera camera = lookAtCamera(dvec3(1, 5, 2), dvec3(1, 0, 2), dvec3(0, 1, 0), 0.8); // straight down along `up`
    EXPECT_LT(glm::distance(dvec3(viewFromWorld(camera) * dvec4(1, 0, 2, 1)), dvec3(0, 0, -5)), kRounding);
    EXPECT_NEAR(glm::determinant(dmat3(camera.worldFromCamera)), 1.0, kRounding);
}

} // namespace
} // namespace torrance
