#include "plan/compensation.h"

#include "brdf/albedo.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

double gain(double roughness, double metallic, double color)
{
    return compensationGain({.leastRoughness = roughness,
                             .greatestRoughness = roughness,
                             .greatestMetallic = metallic,
                             .greatestBaseColor = dvec3(color)});
}

TEST(Compensation, WhiteMetalGainsWhatItsLobeLoses)
{
    // F0 = 1: compensation makes the albedo 1 at every view, so the gain is 1 / (2 int E NoV dNoV) - 1. The mean albedo
    // of GGX with the height-correlated Smith term, alpha = 1, by midpoints.
    double mean = 0;
    constexpr int kSteps = 64;
    for (int i = 0; i < kSteps; ++i) {
        const double NoV = (i + 0.5) / kSteps;
        mean += 2.0 * NoV * brdf::ggxAlbedo(NoV, 1.0).albedo() / kSteps;
    }
    EXPECT_NEAR(gain(1.0, 1.0, 1.0), 1.0 / mean - 1.0, 5e-3);
}

TEST(Compensation, SmoothSurfacesNeedNone)
{
    EXPECT_LT(gain(0.1, 1.0, 1.0), 2e-3); // E > 0.999 but at grazing views
    EXPECT_LT(gain(0.0, 1.0, 1.0), kCompensationThreshold);
}

TEST(Compensation, DependsOnWhatTheMaterialReflects)
{
    EXPECT_LT(gain(0.5, 0.0, 1.0), gain(0.5, 1.0, 1.0));
    EXPECT_LT(gain(0.3, 0.0, 0.8), kCompensationThreshold) << "a white dielectric's lobe is 4 % of its light";
}

TEST(Compensation, ThePlanLeavesItOutWhereItIsNotWorthIt)
{
    Scene scene = test::sceneWith({.metallicFactor = 1.0, .roughnessFactor = 0.8});
    EXPECT_TRUE(makePlan(scene, test::settings("standard")).batches[0].key.compensates);
    EXPECT_FALSE(makePlan(scene, test::settings("gltf")).batches[0].key.compensates);
    scene.materials[0] = {.metallicFactor = 0.0, .roughnessFactor = 0.3};
    EXPECT_FALSE(makePlan(scene, test::settings("standard")).batches[0].key.compensates);
}

Settings withMethods(std::string_view weight, std::string_view compensation)
{
    Settings settings = test::settings("gltf");
    settings.methods.diffuseWeight = brdf::findMethod(brdf::Slot::diffuseWeight, weight);
    settings.methods.multipleScattering = brdf::findMethod(brdf::Slot::multipleScattering, compensation);
    return settings;
}

// What a punctual light's part reads of the table: nothing, the albedo at NoV, or that at NoL as well.
TEST(Compensation, TheTableIsReadWhereAMethodAsksForIt)
{
    Scene scene = test::sceneWith({.metallicFactor = 1.0, .roughnessFactor = 0.8});
    scene.lights.push_back({.kind = Light::Kind::directional});
    const auto text = [&](std::string_view weight, std::string_view compensation) {
        const ShadingPlan plan = makePlan(scene, withMethods(weight, compensation));
        const std::string selected = selectedText(plan, plan.batches[0].key);
        EXPECT_EQ(plan.dfgTable, selected.find("#define DFG_TABLE\n") != std::string::npos);
        return selected;
    };
    const auto has = [](const std::string& selected, const char* name) {
        return selected.find(std::string("#define ") + name + "\n") != std::string::npos;
    };
    EXPECT_FALSE(has(text("fresnel_voh", "none"), "DFG_TABLE"));
    EXPECT_TRUE(has(text("albedo_scaling", "none"), "DFG_TABLE"));
    EXPECT_TRUE(has(text("fresnel_nol_nov", "scale"), "DFG_TABLE"));
    EXPECT_FALSE(has(text("fresnel_voh", "fdez_aguera"), "READS_LIGHT_ALBEDO"));
    EXPECT_TRUE(has(text("fresnel_voh", "kulla_conty"), "READS_LIGHT_ALBEDO"));
    scene.materials[0].roughnessFactor = 0.05; // not worth compensating
    EXPECT_FALSE(has(text("fresnel_voh", "kulla_conty"), "DFG_TABLE"));
    EXPECT_FALSE(has(text("albedo_scaling", "kulla_conty"), "READS_LIGHT_ALBEDO"));
}

} // namespace
} // namespace torrance
