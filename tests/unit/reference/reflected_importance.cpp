#include "reference/reflected_importance.h"

#include "tests/panorama_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

const EnvironmentSampler& sky()
{
    static const EnvironmentSampler sampler(test::panoramaOf([](const dvec3&) { return dvec3(1.0); }, 256));
    return sampler;
}

MaterialPoint materialOf(double roughness, double metallic)
{
    MaterialPoint material;
    material.normal = glm::normalize(dvec3(0.3, 0.5, -0.8));
    material.perceptualRoughness = roughness;
    material.metallic = metallic;
    material.baseColor = dvec3(0.8);
    return material;
}

dvec3 viewOf(const MaterialPoint& material, double NoV)
{
    const dvec3 side = glm::normalize(glm::cross(material.normal, dvec3(0, 1, 0)));
    return NoV * material.normal + std::sqrt(1.0 - NoV * NoV) * side;
}

// Nothing that is drawn by a tile's texels lies farther from its centre than its radius: no direction above the surface
// is left out with the tiles below it.
TEST(ReflectedImportance, EveryDirectionAboveTheSurfaceCanBeDrawn)
{
    const MaterialPoint material = materialOf(0.3, 0.0);
    const auto white = [](const dvec3&) { return dvec3(1.0); };
    for (const int width : {2, 4, 100, 256}) {
        const EnvironmentSampler sampler(test::panoramaOf(white, width));
        const double NoV = width == 100 ? kMinNoV : 0.3;
        const auto distribution =
            sampler.weighed(reflectedImportance(sampler.tiles(), material, viewOf(material, NoV)));
        ASSERT_TRUE(distribution.usable());
        for (int i = 0; i < 100; ++i)
            for (int j = 0; j < 100; ++j) {
                const double z = 1.0 - (i + 0.5) / 50.0, phi = 2.0 * kPi * (j + 0.5) / 100.0;
                const dvec3 d(std::sqrt(1.0 - z * z) * std::cos(phi), z, std::sqrt(1.0 - z * z) * std::sin(phi));
                if (glm::dot(d, material.normal) > 0.0) {
                    ASSERT_GT(sampler.at(d, distribution).density, 0.0) << width << ' ' << i << ' ' << j;
                }
            }
    }
}

// What is below the surface is not drawn, but for the tiles that the horizon crosses.
TEST(ReflectedImportance, LittleIsDrawnBelowTheSurface)
{
    const MaterialPoint material = materialOf(0.5, 0.5);
    const auto distribution = sky().weighed(reflectedImportance(sky().tiles(), material, viewOf(material, 0.7)));
    const float widest = std::ranges::max(sky().tiles(), {}, &EnvironmentSampler::Tile::radius).radius;
    int below = 0;
    constexpr int kSide = 64;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const dvec3 d = sky().draw({(i + 0.5) / kSide, (j + 0.5) / kSide}, distribution);
            const double cosine = glm::dot(d, material.normal);
            ASSERT_GT(cosine, -std::sin(2.0 * double(widest)));
            below += cosine <= 0.0;
        }
    EXPECT_LT(below, kSide * kSide / 20);
}

// Where light comes from straight behind, the half vector has no direction.
TEST(ReflectedImportance, IsFiniteAroundTheSphere)
{
    MaterialPoint material = materialOf(0.0, 1.0);
    for (const EnvironmentSampler::Tile& tile : sky().tiles()) {
        const dvec3 view = -glm::normalize(dvec3(tile.center));
        material.normal = glm::normalize(glm::cross(view, std::abs(view.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
        for (const double value : reflectedImportance(sky().tiles(), material, view)) {
            ASSERT_TRUE(std::isfinite(value));
            ASSERT_GE(value, 0.0);
        }
    }
}

// A mirror seen at a grazing angle has a lobe smaller than a tile, whose factors are huge there: it may not take the
// directions away from the body, which reflects most of the light.
TEST(ReflectedImportance, ALobeIsNoBrighterThanWhatItReflects)
{
    const MaterialPoint material = materialOf(0.02, 0.0);
    const auto importance = reflectedImportance(sky().tiles(), material, viewOf(material, kMinNoV));
    MaterialPoint black = material;
    black.baseColor = dvec3(0.0);
    const auto lobe = reflectedImportance(sky().tiles(), black, viewOf(black, kMinNoV));
    double whole = 0.0, ofLobe = 0.0;
    for (std::size_t i = 0; i < importance.size(); ++i) {
        whole += importance[i] * double(sky().tiles()[i].solidAngle);
        ofLobe += lobe[i] * double(sky().tiles()[i].solidAngle);
    }
    EXPECT_LE(ofLobe, 1.0 + 1e-4);
    EXPECT_NEAR(whole - ofLobe, 0.8, 0.02); // the body's albedo: the cosine's integral over the hemisphere, by tiles
}

} // namespace
} // namespace torrance
