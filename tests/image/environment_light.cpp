// Light from environments that are not uniform.
#include "drawing.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "tests/panorama_of.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

Scene ball(const Material& material, Environment environment)
{
    Scene scene;
    scene.environment = std::move(environment);
    scene.materials.push_back(material);
    scene.shapes.push_back(
        {.kind = AnalyticShape::Kind::sphere, .material = 0, .worldFromObject = dmat4(1.0), .name = "ball"});
    return scene;
}

Picture drawBall(const Scene& scene, const char* irradiance = "irradiance_cube")
{
    Settings settings = settingsOf("gltf", 65);
    settings.methods.environmentDiffuse = brdf::findMethod(brdf::Slot::environmentDiffuse, irradiance);
    return draw(scene, orbitCamera({0.0, kPi / 2}, 4.0, dvec3(0), 0.6), settings);
}

struct Sums
{
    double total = 0.0;
    double peak = 0.0;
};

Sums sumsOf(const Image& image)
{
    Sums sums;
    for (std::size_t i = 0; i < image.texels.size(); i += 4) {
        sums.total += image.texels[i];
        sums.peak = std::max<double>(sums.peak, image.texels[i]);
    }
    return sums;
}

double greatestDifference(const Image& a, const Image& b)
{
    double greatest = 0.0;
    for (std::size_t i = 0; i < a.texels.size(); ++i)
        greatest = std::max(greatest, std::abs(double(a.texels[i]) - b.texels[i]));
    return greatest;
}

TEST(EnvironmentLight, NineHarmonicsAreExactForALinearEnvironment)
{
    // Radiance 1 + 0.8 y lies in bands 0 and 1: harmonics and cube both give 1 + (2/3) 0.8 n.y (clampedCosineBand).
    const Scene scene = ball(plainMaterial(dvec3(1.0), 0.0, 1.0),
                             panoramaOf([](const dvec3& d) { return dvec3(1.0 + 0.8 * d.y); }, 512));
    const Picture cube = drawBall(scene), harmonics = drawBall(scene, "sh9");
    // The cube's texels are within 1e-3 of values up to 1.53; between them, 1/16 apart, a bilinear mean is off by at
    // most (1/16)^2 / 8 of the second derivative, 0.53 here.
    EXPECT_LT(greatestDifference(cube.color, harmonics.color), 1e-3 * 1.53 + 0.53 / (16 * 16 * 8));
    EXPECT_GT(sumsOf(cube.color).peak, 1.2) << "the top is lit by more than the mean";
}

TEST(EnvironmentLight, NineHarmonicsBlurTheEdgeOfASky)
{
    // Half a sky: the clamped cosine's bands 4 and up are missing, some per cent of the light (Ramamoorthi & Hanrahan
    // 2001).
    const Scene scene = ball(plainMaterial(dvec3(1.0), 0.0, 1.0),
                             panoramaOf([](const dvec3& d) { return dvec3(d.x > 0.9 ? 10.0 : 0.0); }, 256));
    EXPECT_GT(greatestDifference(drawBall(scene).color, drawBall(scene, "sh9").color), 0.01);
}

TEST(EnvironmentLight, ASunKeepsItsEnergyWhereverItsTexelLies)
{
    // One texel of 1e6 in front of the ball, a little above. Turned by parts of a texel (0.7 degrees), neither the
    // light that the ball returns nor its highlight may change by more than the turn itself accounts for: below 1 % a
    // degree and 3 %.
    Environment sun = panoramaOf([](const dvec3&) { return dvec3(0.0); }, 512);
    std::fill_n(sun.radiance.at(384, 108), 3, 1e6f);
    Scene scene = ball(plainMaterial(dvec3(1.0), 1.0, 0.4), std::move(sun));
    const Sums still = sumsOf(drawBall(scene).color);
    ASSERT_GT(still.peak, 0.0);
    for (const double degrees : {0.11, 0.23, 0.37, 0.52, 0.66}) {
        scene.environment->rotation = degrees * kPi / 180.0;
        const Sums turned = sumsOf(drawBall(scene).color);
        EXPECT_NEAR(turned.total / still.total, 1.0, 0.01) << degrees;
        EXPECT_NEAR(turned.peak / still.peak, 1.0, 0.03) << degrees;
    }
}

TEST(EnvironmentLight, TheRoughnessSpreadsASunWithoutLosingIt)
{
    // White metal under one sun: what the lobe spreads from a smooth to a rough ball changes its picture's sum by its
    // albedo and by what leaves for other directions, never by orders of magnitude; its peak falls as the lobe widens.
    Environment sun = panoramaOf([](const dvec3&) { return dvec3(0.0); }, 512);
    std::fill_n(sun.radiance.at(384, 108), 3, 1e6f);
    Scene scene = ball(plainMaterial(dvec3(1.0), 1.0, 0.3), std::move(sun));
    Sums before = sumsOf(drawBall(scene).color);
    for (const double roughness : {0.4, 0.5, 0.6}) {
        scene.materials[0].roughnessFactor = roughness;
        const Sums after = sumsOf(drawBall(scene).color);
        EXPECT_LT(after.peak, before.peak) << roughness;
        EXPECT_NEAR(after.total / before.total, 1.0, 0.5) << roughness;
        before = after;
    }
}

} // namespace
} // namespace torrance::test
