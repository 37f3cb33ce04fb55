#include "reference/sphere_light.h"

#include "../math/confidence.h"
#include "math/scrambled_sequence.h"
#include "reference/light_integral.h"
#include "reference/shade.h"

namespace torrance {
namespace {

Light sphere(const dvec3& position, double radius)
{
    Light light;
    light.kind = Light::Kind::point;
    light.color = dvec3(1.0, 0.5, 0.25);
    light.intensity = 7.0;
    light.position = position;
    light.radius = radius;
    return light;
}

/// Irradiance of a surface at the origin with normal +Z, by drawing from the sphere's cone.
Replicates irradiance(const Light& light)
{
    constexpr std::uint32_t kDraws = 1024;
    const SphereLight seen(light, dvec3(0.0), dvec3(0.0));
    Replicates replicates;
    for (std::size_t r = 0; r < kReplicates; ++r) {
        const ScrambledSequence points(hashNumbers({5, r}));
        for (std::uint32_t i = 0; i < kDraws; ++i) {
            const dvec3 l = seen.draw(points[i]);
            const DirectedLight arriving = seen.at(l);
            if (arriving.density > 0.0)
                replicates.values[r] += arriving.radiance * (std::max(0.0, l.z) / arriving.density / double(kDraws));
        }
    }
    return replicates;
}

// A sphere of radiance L wholly above the horizon gives E = pi L sin^2(half angle) cos(theta of its centre), which with
// L = I / (pi r^2) is I cos(theta) / d^2, whatever the radius.
TEST(SphereLight, AboveTheHorizonItsIrradianceIsThePointLights)
{
    const dvec3 direction = glm::normalize(dvec3(0.4, -0.2, 1.0));
    for (const double radius : {0.01, 0.5, 1.9}) {
        const Light light = sphere(2.5 * direction, radius);
        const dvec3 exact = light.color * (light.intensity * direction.z / (2.5 * 2.5));
        EXPECT_TRUE(test::agrees(irradiance(light), exact, 1e-12, 3)) << radius;
    }
}

// From inside, the hemisphere about the centre's direction has the radiance: straight above, E = pi L.
TEST(SphereLight, FromInsideItFillsTheHemisphere)
{
    const Light light = sphere(dvec3(0.0, 0.0, 0.5), 2.0);
    const dvec3 exact = light.color * (light.intensity / (2.0 * 2.0));
    EXPECT_TRUE(test::agrees(irradiance(light), exact, 1e-12, 1));
}

MaterialPoint surfaceOf(double roughness, double metallic)
{
    MaterialPoint material;
    material.perceptualRoughness = roughness;
    material.metallic = metallic;
    material.baseColor = dvec3(0.9, 0.6, 0.3);
    material.occlusion = 0.0; // of the environment, not of lamps
    return material;
}

Replicates reflected(const Light& light, const MaterialPoint& material, const dvec3& view, DirectionChoice choice,
                     std::uint32_t turns)
{
    const LightIntegral integral(brdf::findPreset("gltf"), SphereLight(light, dvec3(0.0), dvec3(0.0)), material, view,
                                 choice);
    Replicates replicates;
    for (std::size_t r = 0; r < kReplicates; ++r)
        replicates.values[r] = integral.sumOfTurns(hashNumbers({static_cast<std::uint64_t>(choice), r}), 0, turns) /
                               (double(turns) * kDirectionsPerTurn);
    return replicates;
}

TEST(SphereLight, SmallOnesAreThePointLight)
{
    const dvec3 view = glm::normalize(dvec3(0.5, 0.0, 1.0));
    const Light light = sphere(dvec3(-1.0, 0.3, 1.5), 1e-4);
    for (const double roughness : {0.3, 1.0}) {
        const MaterialPoint material = surfaceOf(roughness, 0.5);
        const dvec3 exact =
            shadePunctual(*brdf::findPreset("gltf"), material, view, sampleLight(light, dvec3(0.0), dvec3(0.0)));
        // The half angle is 5e-5 rad; over it the lobe, of curvature 1 / alpha^2 < 124, bends by less than 1e-6.
        EXPECT_TRUE(
            test::agrees(reflected(light, material, view, DirectionChoice::combined, 16), exact, 1e-6 * exact.r, 2))
            << roughness;
    }
}

TEST(SphereLight, IsTheSameWhereverDirectionsAreDrawnFrom)
{
    const Light light = sphere(dvec3(-1.0, 0.3, 0.4), 0.8); // partly below the horizon
    for (const double roughness : {0.1, 0.4, 1.0})
        for (const dvec3& view : {dvec3(0.0, 0.0, 1.0), glm::normalize(dvec3(1.0, -0.2, 0.3))}) {
            const MaterialPoint material = surfaceOf(roughness, 0.5);
            const Replicates combined = reflected(light, material, view, DirectionChoice::combined, 1024);
            for (const DirectionChoice choice : {DirectionChoice::brdf, DirectionChoice::light}) {
                Replicates difference = reflected(light, material, view, choice, 1024);
                for (std::size_t r = 0; r < kReplicates; ++r)
                    difference.values[r] -= combined.values[r];
                EXPECT_TRUE(test::agrees(difference, dvec3(0.0), 0.0, 12)) << roughness << ' ' << view.z;
            }
        }
}

} // namespace
} // namespace torrance
