#include "reference/shade.h"

#include "core/error.h"
#include "math/quadrature.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

const brdf::Preset& preset(std::string_view id)
{
    return *brdf::findPreset(id);
}

dvec3 viewAt(double NoV)
{
    return dvec3(std::sqrt(1.0 - NoV * NoV), 0.0, NoV);
}

/// Uniform light as many small directional ones: Gauss in the cosine, midpoints in azimuth.
dvec3 furnaceByLights(const brdf::Preset& methods, const MaterialPoint& material, const dvec3& view)
{
    constexpr int kAzimuths = 64;
    dvec3 sum(0.0);
    const QuadratureRule rule = gaussLegendre(72, 0.0, 1.0);
    for (std::size_t k = 0; k < rule.size(); ++k)
        for (int i = 0; i < kAzimuths; ++i) {
            const double phi = 2.0 * kPi * (i + 0.5) / kAzimuths;
            const double sine = std::sqrt(1.0 - rule.nodes[k] * rule.nodes[k]);
            const LightSample light{dvec3(sine * std::cos(phi), sine * std::sin(phi), rule.nodes[k]),
                                    dvec3(rule.weights[k] * 2.0 * kPi / kAzimuths)};
            sum += shadePunctual(methods, material, view, light);
        }
    return sum;
}

TEST(Shade, FurnaceIsTheIntegralOfPunctualLight)
{
    // The exact albedo behind compensation is dear; half a metal has both lobes.
    const std::pair<const char*, double> cases[] = {{"gltf", 0.0}, {"gltf", 0.5}, {"gltf", 1.0}, {"standard", 0.5}};
    for (const auto& [id, metallic] : cases)
        for (const double roughness : {0.75, 1.0})
            for (const double NoV : {0.2, 0.8}) {
                MaterialPoint material;
                material.baseColor = dvec3(0.9, 0.5, 0.1);
                material.metallic = metallic;
                material.perceptualRoughness = roughness;
                const dvec3 exact = shadeFurnace(preset(id), material, viewAt(NoV), dvec3(1.0));
                const dvec3 summed = furnaceByLights(preset(id), material, viewAt(NoV));
                EXPECT_LT(glm::length(exact - summed), 1e-4)
                    << id << " m " << metallic << " r " << roughness << " NoV " << NoV;
            }
}

TEST(Shade, RoughestWhiteMetalReturnsOneMinusLogTwo)
{
    MaterialPoint material;
    material.metallic = 1.0;
    material.perceptualRoughness = 1.0;
    EXPECT_NEAR(shadeFurnace(preset("gltf"), material, viewAt(1.0), dvec3(1.0)).r, 1.0 - std::log(2.0), 1e-6);
    EXPECT_NEAR(shadeFurnace(preset("standard"), material, viewAt(0.3), dvec3(1.0)).r, 1.0, 1e-12);
}

TEST(Shade, LambertUnderADirectionalLight)
{
    // Facing view and light of one direction: F = F0, so diffuse = (1 - 0.04) c / pi and, at r = 1, D V = 1 / (4 pi).
    MaterialPoint material;
    material.metallic = 0.0;
    material.baseColor = dvec3(0.5);
    Light light;
    light.intensity = 2.0;
    const Illumination illumination{std::span(&light, 1), dvec3(0.0)};
    const dvec3 c = shade(preset("gltf"), illumination, material, dvec3(0.0), dvec3(0.0), viewAt(1.0));
    EXPECT_NEAR(c.r, 2.0 * (0.96 * 0.5 / kPi + 0.04 / (4.0 * kPi)), 1e-12);
}

TEST(Shade, LightBehindTheSurfaceAndUnlitMaterials)
{
    Light light;
    light.direction = dvec3(0, 0, 1);
    const Illumination illumination{std::span(&light, 1), dvec3(0.0)};
    MaterialPoint material;
    material.emissive = dvec3(1, 2, 3);
    EXPECT_EQ(shade(preset("gltf"), illumination, material, dvec3(0), dvec3(0), viewAt(0.5)), dvec3(1, 2, 3));
    material.unlit = true;
    material.baseColor = dvec3(0.25);
    EXPECT_EQ(shade(preset("gltf"), illumination, material, dvec3(0), dvec3(0), viewAt(0.5)), dvec3(0.25));
}

TEST(Shade, OcclusionTakesFromTheEnvironmentOnly)
{
    MaterialPoint material;
    const Illumination uniform{{}, dvec3(2.0)};
    const dvec3 open = shade(preset("gltf"), uniform, material, dvec3(0), dvec3(0), viewAt(0.5));
    material.occlusion = 0.25;
    const dvec3 occluded = shade(preset("gltf"), uniform, material, dvec3(0), dvec3(0), viewAt(0.5));
    EXPECT_LT(glm::distance(occluded, 0.25 * open), 1e-15);
}

TEST(Shade, OnlyConstantEnvironmentsAreUniform)
{
    Environment environment;
    environment.radiance = Image(4, 2, 3, 0.5f);
    environment.intensity = 3.0;
    EXPECT_EQ(uniformRadiance(environment), dvec3(1.5));
    environment.radiance.at(3, 1)[2] = 0.25f;
    EXPECT_FALSE(uniformRadiance(environment));
}

TEST(Shade, FurnaceRefusesMethodsItHasNoFormulaFor)
{
    brdf::Preset other = preset("gltf");
    other.diffuse = brdf::findMethod(brdf::Slot::distribution, "ggx");
    EXPECT_THROW(shadeFurnace(other, MaterialPoint{}, viewAt(1.0), dvec3(1.0)), Error);
}

} // namespace
} // namespace torrance
