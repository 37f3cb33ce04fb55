#include "reference/light_integral.h"

#include "../math/confidence.h"
#include "brdf/albedo.h"
#include "math/latlong.h"
#include "reference/shade.h"
#include "tests/panorama_of.h"

#include <string>

namespace torrance {
namespace {

using test::difference;
using test::panoramaOf;

/// A sky, a ground of another colour, and a lamp a hundred times as bright.
Environment testEnvironment()
{
    return panoramaOf(
        [](const dvec3& d) {
            const dvec3 sky = d.y > 0.0 ? dvec3(0.4, 0.6, 1.0) : dvec3(0.3, 0.2, 0.1);
            return glm::dot(d, glm::normalize(dvec3(1.0, 1.0, 0.5))) > 0.97 ? dvec3(60.0, 50.0, 40.0) : sky;
        },
        64);
}

struct Case
{
    MaterialPoint material;
    dvec3 view;
};

/// Views from head on to grazing, smooth to rough, dielectric to metal, about a normal that no axis favours.
std::vector<Case> allCases()
{
    const dvec3 n = glm::normalize(dvec3(0.3, 0.5, -0.8)), side = glm::normalize(glm::cross(n, dvec3(0, 1, 0)));
    std::vector<Case> cases;
    for (const double NoV : {1.0, 0.6, 0.1})
        for (const double roughness : {0.0, 0.2, 0.5, 1.0})
            for (const double metallic : {0.0, 0.4, 1.0}) {
                Case c;
                c.material.normal = n;
                c.material.baseColor = dvec3(0.9, 0.5, 0.2);
                c.material.perceptualRoughness = roughness;
                c.material.metallic = metallic;
                c.view = NoV * n + std::sqrt(1.0 - NoV * NoV) * side;
                cases.push_back(c);
            }
    return cases;
}

Replicates integrate(const brdf::Preset& preset, const LightIntegral::Source& source, const Case& c,
                     DirectionChoice choice, std::uint32_t turns)
{
    const LightIntegral integral(&preset, source, c.material, c.view, choice);
    Replicates replicates;
    for (std::size_t r = 0; r < kReplicates; ++r) {
        const std::uint64_t key = hashNumbers({static_cast<std::uint64_t>(choice), r}); // independent of other choices
        replicates.values[r] = integral.sumOfTurns(key, 0, turns) / (double(turns) * kDirectionsPerTurn);
    }
    return replicates;
}

std::string describe(const Case& c)
{
    return "roughness " + std::to_string(c.material.perceptualRoughness) + " metallic " +
           std::to_string(c.material.metallic) + " NoV " + std::to_string(glm::dot(c.material.normal, c.view));
}

TEST(LightIntegral, OfAUniformEnvironmentIsTheFurnace)
{
    const dvec3 radiance(0.5, 1.0, 2.0);
    const EnvironmentSampler environment(panoramaOf([&](const dvec3&) { return radiance; }, 16));
    const std::vector<Case> cases = allCases();
    for (const char* preset : {"gltf", "standard"})
        for (const Case& c : cases) {
            const brdf::Preset& methods = *brdf::findPreset(preset);
            // The closed form is within 2e-7 of a lobe's energy (brdf/albedo.h), twice where it is compensated.
            EXPECT_TRUE(test::agrees(integrate(methods, &environment, c, DirectionChoice::combined, 64),
                                     shadeFurnace(methods, c.material, c.view, radiance), 1e-6, 2 * cases.size()))
                << preset << " " << describe(c);
        }
}

TEST(LightIntegral, IsTheSameWhereverDirectionsAreDrawnFrom)
{
    const EnvironmentSampler environment(testEnvironment());
    const brdf::Preset& standard = *brdf::findPreset("standard");
    const std::vector<Case> cases = allCases();
    for (const Case& c : cases) {
        const Replicates combined = integrate(standard, &environment, c, DirectionChoice::combined, 256);
        EXPECT_TRUE(
            test::agrees(difference(combined, integrate(standard, &environment, c, DirectionChoice::brdf, 1024)),
                         dvec3(0.0), 0.0, 2 * cases.size()))
            << "brdf: " << describe(c);
        // Smooth lobes are met by few of the environment's directions, and means of few are not normal.
        if (c.material.perceptualRoughness >= 0.5) {
            EXPECT_TRUE(
                test::agrees(difference(combined, integrate(standard, &environment, c, DirectionChoice::light, 1024)),
                             dvec3(0.0), 0.0, 2 * cases.size()))
                << "environment: " << describe(c);
        }
    }
}

// No tile above the surface has light: there is nothing to draw by, and nothing that is reflected.
TEST(LightIntegral, OfLightFromBelowIsNothing)
{
    const std::vector<Case> cases = allCases();
    const dvec3 down = -cases.front().material.normal;
    const EnvironmentSampler environment(
        panoramaOf([&](const dvec3& d) { return dvec3(glm::dot(d, down) > 0.9 ? 5.0 : 0.0); }, 64));
    for (const Case& c : cases) {
        const Replicates light =
            integrate(*brdf::findPreset("standard"), &environment, c, DirectionChoice::combined, 16);
        for (const dvec3& value : light.values)
            EXPECT_EQ(value, dvec3(0.0)) << describe(c);
    }
}

TEST(LightIntegral, OfTheRoughestWhiteMetalHeadOnIsOneMinusLogTwo)
{
    const EnvironmentSampler environment(panoramaOf([](const dvec3&) { return dvec3(1.0); }, 16));
    Case c;
    c.material.metallic = 1.0;
    c.view = c.material.normal; // alpha = 1 and white are the defaults
    EXPECT_TRUE(test::agrees(integrate(*brdf::findPreset("gltf"), &environment, c, DirectionChoice::combined, 256),
                             dvec3(1.0 - std::log(2.0)), 0.0, 1));
}

TEST(LightIntegral, OfASunInOneTexelIsThatOfADirectionalLight)
{
    // A texel of 1e6 in a black panorama: a light of 1e6 times its solid angle. Where the BRDF is as good as constant
    // over the 0.7 degrees that bilinear interpolation spreads it to, the closed form of a directional light holds.
    constexpr int kWidth = 1024, kColumn = 300, kRow = 150;
    Environment sun = panoramaOf([](const dvec3&) { return dvec3(0.0); }, kWidth);
    std::fill_n(sun.radiance.at(kColumn, kRow), 3, 1e6f);
    const EnvironmentSampler environment(sun);
    const dvec3 towards = directionFromLatLong({(kColumn + 0.5) / kWidth, (kRow + 0.5) / (kWidth / 2)});
    const double solidAngle = latLongTexelSolidAngle(kRow, kWidth, kWidth / 2);
    const brdf::Preset& gltf = *brdf::findPreset("gltf");
    std::size_t lit = 0;
    for (const Case& c : allCases()) {
        if (c.material.perceptualRoughness < 0.5 || glm::dot(c.material.normal, towards) < 0.1)
            continue;
        const dvec3 exact = shadePunctual(gltf, c.material, c.view, {towards, dvec3(1e6 * solidAngle)});
        // The spread's second moment about the direction is 2 / 6 of the squared texel (6 mrad); the BRDF's second
        // derivative is at most some 1 / alpha^2 = 16 of its value.
        const double texel = 2.0 * kPi / kWidth;
        EXPECT_TRUE(test::agrees(integrate(gltf, &environment, c, DirectionChoice::combined, 64), exact,
                                 16.0 * texel * texel / 3.0 * exact.r, allCases().size()))
            << describe(c);
        ++lit;
    }
    EXPECT_GT(lit, 5u);
}

} // namespace
} // namespace torrance
