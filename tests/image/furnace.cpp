// The white furnace: src/study/furnace_cases.cpp has the cases and says what is allowed.
#include "study/furnace_cases.h"

#include "drawing.h"
#include "reference/pixel_condition.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

TEST(Furnace, MetalReturnsWhatTheModelSays)
{
    expectDrawnAsComputed(furnaceCases("gltf", 1.0));
}

TEST(Furnace, HalfMetalReturnsWhatTheModelSays)
{
    expectDrawnAsComputed(furnaceCases("gltf", 0.5));
}

TEST(Furnace, DielectricReturnsWhatTheModelSays)
{
    expectDrawnAsComputed(furnaceCases("gltf", 0.0));
}

TEST(Furnace, CompensatedWhiteMetalReturnsAll)
{
    expectDrawnAsComputed(furnaceCases("standard", 1.0));
}

// Each method of the slots that environment light must agree with, in gltf's place, on a smooth and on a rough sphere.
void expectFurnaceOf(brdf::Slot slot, double metallic)
{
    for (const brdf::Method& method : brdf::allMethods()) {
        if (method.slot != slot)
            continue;
        brdf::Preset methods = *brdf::findPreset("gltf");
        methods[slot] = &method;
        const std::vector<PictureCase> all = furnaceCases(methods, method.id, metallic);
        constexpr std::size_t kSmooth = 2, kRough = 6; // 0.2, 0.85
        expectDrawnAsComputed({all[kSmooth], all[kRough]});
    }
}

TEST(Furnace, EveryMultipleScatteringReturnsWhatItSays)
{
    expectFurnaceOf(brdf::Slot::multipleScattering, 1.0);
}

TEST(Furnace, EveryWeightOfTheBodyReturnsWhatItSays)
{
    expectFurnaceOf(brdf::Slot::diffuseWeight, 0.0);
}

// A white dielectric whose body is weighted by the albedo of its lobe returns all light too.
TEST(Furnace, AlbedoScalingReturnsAll)
{
    brdf::Preset methods = *brdf::findPreset("standard");
    methods.diffuseWeight = brdf::findMethod(brdf::Slot::diffuseWeight, "albedo_scaling");
    methods.multipleScattering = brdf::findMethod(brdf::Slot::multipleScattering, "kulla_conty");
    for (const PictureCase& c : furnaceCases(methods, "albedo_scaling", 0.0)) {
        const PixelInputs inputs = pixelInputs(c.scene, 0, c.camera, 20, 20, 10, 10);
        EXPECT_NEAR(pixelRadiance(methods, inputs).value().r, 1.0, 1e-12);
    }
}

} // namespace
} // namespace torrance::test
