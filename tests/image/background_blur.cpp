// The environment seen behind a scene through a lobe.
#include "drawing.h"
#include "math/latlong.h"
#include "prepare/environment_maps.h"
#include "scene/camera_view.h"
#include "scenes.h"
#include "tests/panorama_of.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr int kPanoramaWidth = 256;
constexpr int kLevels = 4; // of the chain that it gives
constexpr int kSize = 12;

Scene glowing()
{
    Scene scene;
    scene.environment = panoramaOf(glow, kPanoramaWidth);
    scene.environment->rotation = 0.7;
    scene.materials.push_back(plainMaterial(dvec3(1.0), 0.0, 0.5));
    scene.shapes.push_back(
        {.kind = AnalyticShape::Kind::sphere, .material = 0, .worldFromObject = dmat4(1.0), .name = "ball"});
    return scene;
}

// The mean of the radiance around `n` (the panorama's axes) under D(h) n.l of N = V = R, as the midpoints of cells see
// it: Karis, Real Shading in Unreal Engine 4, 2013.
dvec3 blurred(const dvec3& n, double alpha)
{
    constexpr int kRows = 180;
    dvec3 sum(0.0);
    double weights = 0.0;
    for (int y = 0; y < kRows; ++y)
        for (int x = 0; x < 2 * kRows; ++x) {
            const dvec3 l = directionFromLatLong({(x + 0.5) / (2 * kRows), (y + 0.5) / kRows});
            const double NoL = glm::dot(n, l);
            if (NoL <= 0.0)
                continue;
            const double NoH = glm::dot(n, glm::normalize(n + l)), a2 = alpha * alpha;
            const double d = NoH * NoH * (a2 - 1.0) + 1.0;
            const double weight = a2 / (d * d) * NoL * latLongTexelSolidAngle(y, 2 * kRows, kRows);
            sum += weight * glow(l);
            weights += weight;
        }
    return sum / weights;
}

// A camera in front of the ball that looks away from it.
Camera awayCamera()
{
    Camera camera = {.name = "away", .verticalFov = 1.2, .nearPlane = 0.1};
    camera.worldFromCamera[3] = dvec4(0.0, 0.0, -3.0, 1.0);
    return camera;
}

dvec3 panoramaDirection(const Scene& scene, const dvec3& world)
{
    const double c = std::cos(scene.environment->rotation), s = std::sin(scene.environment->rotation);
    return {c * world.x - s * world.z, world.y, s * world.x + c * world.z};
}

Picture drawn(const Scene& scene, double blur)
{
    Settings settings = settingsOf("standard", kSize);
    settings.background = BackgroundKind::environment;
    settings.backgroundBlur = blur;
    return draw(scene, awayCamera(), settings);
}

// At roughnesses that are levels of the chain: those are within 1 %, and between the texels of the last, 1/4 apart, a
// bilinear look-up misses up to 2 h^2 / 8 of the curvature, 1/2 there (as in environment_methods.cpp).
TEST(BackgroundBlur, IsTheMeanOverTheLobe)
{
    const Scene scene = glowing();
    for (const int level : {1, 2, 3}) {
        const double alpha = levelAlpha(level, kLevels);
        const Picture picture = drawn(scene, std::sqrt(alpha));
        for (int y = 0; y < kSize; y += 3)
            for (int x = 0; x < kSize; x += 3) {
                const Ray ray = primaryRay(awayCamera(), kSize, kSize, x + 0.5, y + 0.5);
                const dvec3 exact = blurred(panoramaDirection(scene, ray.direction), alpha);
                const dvec4 pixel = pixelOf(picture, x, y);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(pixel[c], exact[c], 1.8e-2 * exact[c]) << "level " << level << " at " << x << ", " << y;
                EXPECT_EQ(pixel.a, 1.0);
            }
    }
}

// None is the panorama itself, which has a texel per degree and a half: bilinear between them.
TEST(BackgroundBlur, NoneIsSharp)
{
    const Scene scene = glowing();
    const Picture picture = drawn(scene, 0.0);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const Ray ray = primaryRay(awayCamera(), kSize, kSize, x + 0.5, y + 0.5);
            const dvec3 exact = glow(panoramaDirection(scene, glm::normalize(ray.direction)));
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(pixelOf(picture, x, y)[c], exact[c], 1.8e-2 * exact[c]);
        }
}

} // namespace
} // namespace torrance::test
