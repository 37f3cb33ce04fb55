#include "reference/physical_surface.h"

#include "../math/confidence.h"
#include "math/sampling.h"
#include "math/scrambled_sequence.h"

namespace torrance {
namespace {

const InterfaceAlbedo& glass()
{
    static const InterfaceAlbedo albedo(1.5);
    return albedo;
}

MaterialPoint materialOf(const dvec3& baseColor, double metallic, double roughness)
{
    MaterialPoint material;
    material.baseColor = baseColor;
    material.metallic = metallic;
    material.perceptualRoughness = roughness;
    return material;
}

dvec3 viewAt(double NoV)
{
    return {std::sqrt(1.0 - NoV * NoV), 0.0, NoV};
}

/// All light that comes back under uniform light of radiance 1.
Replicates furnace(const MaterialPoint& material, double NoV)
{
    const PhysicalSurface surface(glass(), material);
    const dvec3 v = viewAt(NoV);
    const dvec2 alpha(std::max(material.perceptualRoughness * material.perceptualRoughness, 1e-4));
    Replicates replicates;
    constexpr std::uint32_t kDraws = 2048;
    for (std::size_t r = 0; r < kReplicates; ++r) {
        const ScrambledSequence lobe(hashNumbers({1, r})), cosine(hashNumbers({2, r}));
        for (std::uint32_t i = 0; i < kDraws; ++i) {
            const dvec3 l = i % 2 ? sampleCosine(cosine[i / 2]) : sampleGgxReflection(v, alpha, lobe[i / 2]);
            NumberStream numbers(hashNumbers({3, r, i}));
            if (l.z > 0.0)
                replicates.values[r] += surface.response(v, l, numbers) * 2.0 /
                                        (cosineDensity(l) + ggxReflectionDensity(v, alpha, l)) / double(kDraws);
        }
    }
    return replicates;
}

TEST(PhysicalSurface, SmoothInterfaceHasFresnelsAlbedo)
{
    // Fresnel's equations at index 1.5: 0.04 head on; at 60 degrees, cos t = sqrt(2/3): s = ((.5 - 1.5 c) / (.5 + 1.5
    // c))^2, p = ((.75 - c) / (.75 + c))^2. A smooth lobe is narrow: all walks meet the same facet.
    const double c = std::sqrt(2.0 / 3.0);
    const double s = (0.5 - 1.5 * c) / (0.5 + 1.5 * c), p = (0.75 - c) / (0.75 + c);
    EXPECT_NEAR(glass().at(1.0, 0.0), 0.04, 1e-6);
    EXPECT_NEAR(glass().at(0.5, 0.0), 0.5 * (s * s + p * p), 1e-3); // between nodes
    // The mean of a smooth interface of index 1.5 is 0.0918 (Egan & Hilgeman 1979; Walsh 1926's closed form).
    EXPECT_NEAR(glass().average(0.0), 0.0918, 5e-4);
}

TEST(PhysicalSurface, MetalHasItsBaseColourAtNormalIncidenceAndWhiteLosesNothing)
{
    const PhysicalSurface gold(glass(), materialOf(dvec3(0.9, 0.6, 0.3), 1.0, 0.5));
    const dvec4 normal = brdf::facetReflectance(gold.facets, 1.0);
    EXPECT_NEAR(glm::length(dvec3(normal) - dvec3(0.9, 0.6, 0.3)), 0.0, 1e-12);
    // Not the smoothest: there light is so seldom reflected twice that means of this many draws are not normal.
    for (const double roughness : {0.4, 0.7, 1.0})
        for (const double NoV : {1.0, 0.3, 0.05})
            EXPECT_TRUE(test::agrees(furnace(materialOf(dvec3(1.0), 1.0, roughness), NoV), dvec3(1.0),
                                     5.0 * (1.0 - kMostReflectance), 9))
                << roughness << ' ' << NoV; // two or three reflections each lose 1e-6
}

TEST(PhysicalSurface, BlackMetalIsBlack)
{
    NumberStream numbers(1);
    const PhysicalSurface black(glass(), materialOf(dvec3(0.0), 1.0, 0.5));
    EXPECT_EQ(black.response(viewAt(0.1), viewAt(0.2), numbers), dvec3(0.0));
}

TEST(PhysicalSurface, WhiteBodyUnderItsInterfaceReturnsAllLight)
{
    // Exactly so where the body is Lambertian, roughness 0. Bilinear interpolation between the nodes is off by less
    // than 2e-3 of E, and a rough body leaves by other angles than a Lambertian one: a per cent.
    for (const auto& [roughness, slack] : {std::pair(0.0, 4e-3), {0.3, 1e-2}, {0.6, 2e-2}, {1.0, 3e-2}})
        for (const double NoV : {1.0, 0.5, 0.2})
            EXPECT_TRUE(test::agrees(furnace(materialOf(dvec3(1.0), 0.0, roughness), NoV), dvec3(1.0), slack, 12))
                << roughness << ' ' << NoV;
}

TEST(PhysicalSurface, IsReciprocal)
{
    const PhysicalSurface surface(glass(), materialOf(dvec3(0.9, 0.6, 0.3), 0.4, 0.7));
    const dvec3 v = viewAt(0.8), l(0.1, std::sqrt(1.0 - 0.01 - 0.09), 0.3);
    Replicates difference;
    for (std::size_t r = 0; r < kReplicates; ++r)
        for (std::uint64_t i = 0; i < 4096; ++i) {
            NumberStream forth(hashNumbers({1, r, i})), back(hashNumbers({2, r, i}));
            difference.values[r] += (surface.response(v, l, forth) / l.z - surface.response(l, v, back) / v.z) / 4096.0;
        }
    EXPECT_TRUE(test::agrees(difference, dvec3(0.0), 1e-12, 1));
}

} // namespace
} // namespace torrance
