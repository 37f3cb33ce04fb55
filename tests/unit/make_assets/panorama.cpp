#include "make_assets/panorama.h"
#include "make_assets/sky.h"
#include "make_assets/studio.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace torrance::assets {
namespace {

// u = 0.5 + atan2(z, x) / 2 pi, v = acos(y) / pi: the convention of scene/scene.h, worked out by hand for the six axes.
TEST(Panorama, AxesLieWhereTheConventionPutsThem)
{
    const auto expectDirection = [](double u, double v, const dvec3& expected) {
        EXPECT_LT(glm::length(panoramaDirection(u, v) - expected), 1e-15) << "u=" << u << " v=" << v;
    };
    expectDirection(0.5, 0.5, dvec3(1, 0, 0));
    expectDirection(0.75, 0.5, dvec3(0, 0, 1));
    expectDirection(0.25, 0.5, dvec3(0, 0, -1));
    expectDirection(0.0, 0.5, dvec3(-1, 0, 0));
    expectDirection(0.3, 0.0, dvec3(0, 1, 0));
    expectDirection(0.3, 1.0, dvec3(0, -1, 0));
}

TEST(Panorama, SolidAnglesAddUpToTheSphere)
{
    double sum = 0.0;
    for (int y = 0; y < 64; ++y)
        sum += 128 * texelSolidAngle(128, 64, y);
    EXPECT_NEAR(sum, 4.0 * kPi, 1e-12);
}

// A uniform environment of 1 lights a white diffuse surface to 1. The midpoint rule over texels of 2.8 degrees is near
// 2e-4.
TEST(Panorama, UniformLightShowsWhiteAsOne)
{
    const Image uniform(128, 64, 3, 1.0f);
    for (const dvec3& normal : {dvec3(0, 1, 0), dvec3(1, 0, 0), glm::normalize(dvec3(1, -2, 3))})
        EXPECT_NEAR(whiteRadiance(uniform, normal).g, 1.0, 5e-4);
}

// The disc's solid angle, 2 pi (1 - cos of its radius), times its radiance: what the sun's texels must add up to.
TEST(Sky, SunKeepsItsEnergy)
{
    constexpr int kWidth = 1024;
    constexpr int kHeight = 512;
    const Image sky = skyPanorama(kWidth, kHeight);
    double energy = 0.0;
    float peak = 0.0f;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float green = sky.at(x, y)[1];
            peak = std::max(peak, green);
            if (green > 100.0f) // the sky itself stays below 20
                energy += green * texelSolidAngle(kWidth, kHeight, y);
        }
    const double expected = sunRadiance().g * 2.0 * kPi * (1.0 - std::cos(kSunAngularRadius));
    // The sky behind the disc adds at most 20 in 1e5; a covered sliver below the threshold takes as little.
    EXPECT_NEAR(energy / expected, 1.0, 1e-3);
    EXPECT_GE(peak, 1e5f);
}

TEST(Sky, IsFiniteAndBluerAwayFromTheSunThanTheSun)
{
    const Image sky = skyPanorama(128, 64);
    EXPECT_TRUE(
        std::all_of(sky.texels.begin(), sky.texels.end(), [](float x) { return std::isfinite(x) && x >= 0.0f; }));
    const float* zenith = sky.at(0, 4);
    EXPECT_GT(zenith[2], zenith[0]);
    EXPECT_GT(sunRadiance().r, sunRadiance().b);
}

// The scale that studio.h promises: a mean of 1 on a white surface that faces up and to the camera.
TEST(Studio, WhiteFacingUpAndForwardIsOne)
{
    const Image studio = studioPanorama(256, 128);
    const dvec3 white = whiteRadiance(studio, glm::normalize(dvec3(0, 1, 1)));
    EXPECT_NEAR((white.r + white.g + white.b) / 3.0, 1.0, 1e-5);
    // The key light stands on the left.
    EXPECT_GT(whiteRadiance(studio, dvec3(-1, 0, 0)).g, whiteRadiance(studio, dvec3(1, 0, 0)).g);
}

} // namespace
} // namespace torrance::assets
