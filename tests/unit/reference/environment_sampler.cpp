#include "reference/environment_sampler.h"

#include "../math/chi_square.h"
#include "math/latlong.h"

#include <gtest/gtest.h>

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

TEST(EnvironmentSampler, DrawsFromItsDensity)
{
    const Environment environment = patchwork();
    const EnvironmentSampler sampler(environment);
    // Half texels: between their edges the density over (u, v) is bilinear, and its mean is that of the middle.
    constexpr int kColumns = 32, kRows = 16, kSamples = 1000000;
    std::vector<double> expected, counts(kColumns * kRows, 0.0);
    double integral = 0.0;
    for (int y = 0; y < kRows; ++y)
        for (int x = 0; x < kColumns; ++x) {
            const double u = (x + 0.5) / kColumns, v = (y + 0.5) / kRows;
            const double solidAngle = 2.0 * kPi * kPi * std::sin(kPi * v) / (kColumns * kRows); // per (u, v) there
            const double share = sampler.at(worldDirection(environment, u, v)).density * solidAngle;
            integral += share;
            expected.push_back(share * kSamples);
        }
    EXPECT_NEAR(integral, 1.0, 1e-12);
    std::mt19937_64 generator(9);
    std::uniform_real_distribution<double> uniform;
    for (int i = 0; i < kSamples; ++i) {
        const double a = uniform(generator), b = uniform(generator);
        const dvec3 d = sampler.draw({a, b});
        const double c = std::cos(environment.rotation), s = std::sin(environment.rotation);
        const dvec2 place = latLongFromDirection({c * d.x - s * d.z, d.y, s * d.x + c * d.z});
        const int x = std::min(static_cast<int>(place.x * kColumns), kColumns - 1);
        const int y = std::min(static_cast<int>(place.y * kRows), kRows - 1);
        counts[static_cast<std::size_t>(y * kColumns + x)] += 1.0;
    }
    EXPECT_GE(test::chiSquareLikelihood(expected, counts), test::kFamilyLevel);
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
