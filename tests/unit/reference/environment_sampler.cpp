#include "reference/environment_sampler.h"

#include "../math/chi_square.h"
#include "math/latlong.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace torrance {
namespace {

/// Noise with a black quarter, a bright texel, and another in the row at the pole.
Environment patchwork()
{
    Environment environment;
    environment.radiance = Image(16, 8, 3);
    std::mt19937 generator(5);
    for (float& value : environment.radiance.texels)
        value = static_cast<float>(generator() % 1000) * 1e-3f;
    for (int y = 2; y < 6; ++y)
        for (int x = 3; x < 7; ++x)
            std::fill_n(environment.radiance.at(x, y), 3, 0.0f);
    environment.radiance.at(0, 4)[1] = 50.0f; // at the seam
    environment.radiance.at(9, 0)[2] = 100.0f;
    environment.rotation = 1.1;
    environment.intensity = 3.0;
    return environment;
}

/// Direction in the world of a place in the panorama: turned counter-clockwise seen from above (scene.h).
dvec3 worldDirection(const Environment& environment, double u, double v)
{
    const dvec3 d = directionFromLatLong({u, v});
    const double c = std::cos(environment.rotation), s = std::sin(environment.rotation);
    return {c * d.x + s * d.z, d.y, -s * d.x + c * d.z};
}

TEST(EnvironmentSampler, RadianceIsThatOfTheTexelAtItsCentreAndTheirMeanBetween)
{
    const Environment environment = patchwork();
    const EnvironmentSampler sampler(environment);
    const auto texel = [&](int x, int y) {
        const float* rgb = environment.radiance.at(x, y);
        return 3.0 * dvec3(rgb[0], rgb[1], rgb[2]);
    };
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x) {
            const dvec3 centre = sampler.at(worldDirection(environment, (x + 0.5) / 16, (y + 0.5) / 8)).radiance;
            EXPECT_NEAR(glm::length(centre - texel(x, y)), 0.0, 1e-9 * (1.0 + glm::length(texel(x, y))));
            const dvec3 between = sampler.at(worldDirection(environment, (x + 1.0) / 16, (y + 0.5) / 8)).radiance;
            EXPECT_NEAR(glm::length(between - 0.5 * (texel(x, y) + texel((x + 1) % 16, y))), 0.0, 1e-9 * 300.0);
        }
}

// The density's integral is 1, and of many directions as many lie in each part of the sphere as it says.
void expectDrawsFromItsDensity(const Environment& environment, const EnvironmentSampler& sampler,
                               const EnvironmentSampler::Distribution& distribution)
{
    // Half texels: between their edges the density over (u, v) is bilinear, and its mean is that of the middle.
    constexpr int kColumns = 32, kRows = 16, kSamples = 1000000;
    std::vector<double> expected, counts(kColumns * kRows, 0.0);
    double integral = 0.0;
    for (int y = 0; y < kRows; ++y)
        for (int x = 0; x < kColumns; ++x) {
            const double u = (x + 0.5) / kColumns, v = (y + 0.5) / kRows;
            const double solidAngle = 2.0 * kPi * kPi * std::sin(kPi * v) / (kColumns * kRows); // per (u, v) there
            const double share = sampler.at(worldDirection(environment, u, v), distribution).density * solidAngle;
            integral += share;
            expected.push_back(share * kSamples);
        }
    EXPECT_NEAR(integral, 1.0, 1e-12);
    std::mt19937_64 generator(9);
    std::uniform_real_distribution<double> uniform;
    for (int i = 0; i < kSamples; ++i) {
        const double a = uniform(generator), b = uniform(generator);
        const dvec3 d = sampler.draw({a, b}, distribution);
        const double c = std::cos(environment.rotation), s = std::sin(environment.rotation);
        const dvec2 place = latLongFromDirection({c * d.x - s * d.z, d.y, s * d.x + c * d.z});
        const int x = std::min(static_cast<int>(place.x * kColumns), kColumns - 1);
        const int y = std::min(static_cast<int>(place.y * kRows), kRows - 1);
        counts[static_cast<std::size_t>(y * kColumns + x)] += 1.0;
    }
    EXPECT_GE(test::chiSquareLikelihood(expected, counts), test::kFamilyLevel);
}

TEST(EnvironmentSampler, DrawsFromItsDensity)
{
    const Environment environment = patchwork();
    const EnvironmentSampler sampler(environment);
    expectDrawsFromItsDensity(environment, sampler, sampler.plain());
}

// Tiles of one texel here, some of them without importance, at the seam and at a pole, too.
TEST(EnvironmentSampler, DrawsFromItsDensityTimesAnImportance)
{
    const Environment environment = patchwork();
    const EnvironmentSampler sampler(environment);
    std::vector<double> importance(sampler.tiles().size());
    std::mt19937 generator(11);
    for (double& value : importance)
        value = generator() % 3 == 0 ? 0.0 : static_cast<double>(generator() % 1000);
    expectDrawsFromItsDensity(environment, sampler, sampler.weighed(importance));
    EXPECT_FALSE(sampler.weighed(std::vector<double>(importance.size(), 0.0)).usable());
}

// Tiles of several texels, of which those at the right and at the bottom are cut off by the picture's edges. Even
// light: the density of a direction says which tile it lies in.
TEST(EnvironmentSampler, TilesCoverThePanorama)
{
    const int width = 3 * EnvironmentSampler::kMostTilesAcross + 2, height = 101; // tiles of 4 x 4 texels
    Environment environment;
    environment.radiance = Image(width, height, 3);
    std::ranges::fill(environment.radiance.texels, 1.0f);
    const EnvironmentSampler sampler(environment);
    const std::size_t across = (static_cast<std::size_t>(width) + 3) / 4,
                      down = (static_cast<std::size_t>(height) + 3) / 4;
    ASSERT_EQ(sampler.tiles().size(), across * down);
    double sphere = 0.0;
    for (const EnvironmentSampler::Tile& tile : sampler.tiles())
        sphere += static_cast<double>(tile.solidAngle);
    EXPECT_NEAR(sphere, 4.0 * kPi, 1e-4);
    for (const std::size_t chosen : {std::size_t(0), across - 1, across * down / 2, across * down - 1}) {
        std::vector<double> importance(across * down, 0.0);
        importance[chosen] = 1.0;
        const auto distribution = sampler.weighed(importance);
        const EnvironmentSampler::Tile& tile = sampler.tiles()[chosen];
        for (int i = 0; i < 32; ++i)
            for (int j = 0; j < 32; ++j) {
                const dvec3 d = sampler.draw({(i + 0.5) / 32, (j + 0.5) / 32}, distribution);
                ASSERT_LE(std::acos(std::min(1.0, glm::dot(d, dvec3(tile.center)))), double(tile.radius) + 1e-4)
                    << chosen;
            }
    }
}

TEST(EnvironmentSampler, TheSquaresCornersAreDirections)
{
    const EnvironmentSampler sampler(patchwork());
    for (const double x : {0.0, 0x1p-33, 0.5, 1.0 - 0x1p-33})
        for (const double y : {0.0, 0x1p-33, 0.5, 1.0 - 0x1p-33}) {
            const dvec3 d = sampler.draw({x, y});
            EXPECT_NEAR(glm::length(d), 1.0, 1e-12);
            EXPECT_GT(sampler.at(d).density, 0.0) << x << ' ' << y;
        }
}

TEST(EnvironmentSampler, BlackOrSwitchedOffIsDark)
{
    Environment environment = patchwork();
    EXPECT_FALSE(EnvironmentSampler(environment).dark());
    environment.intensity = 0.0;
    EXPECT_TRUE(EnvironmentSampler(environment).dark());
    environment.intensity = 1.0;
    std::ranges::fill(environment.radiance.texels, 0.0f);
    EXPECT_TRUE(EnvironmentSampler(environment).dark());
}

} // namespace
} // namespace torrance
