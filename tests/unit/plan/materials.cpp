#include "scenes.h"

#include <gtest/gtest.h>

// What a scene does not use is not planned. Expected factors come from glTF 2.0's definition: texel times factor,
// colours decoded by the sRGB curve of IEC 61966-2-1.
namespace torrance {
namespace {

using test::addTexture;
using test::sceneWith;
using test::settings;

const Material& planned(const ShadingPlan& plan)
{
    return plan.materials[0].material;
}

TEST(MaterialPlan, AConstantColourBecomesAFactor)
{
    Scene scene = sceneWith({});
    scene.materials[0].baseColor = addTexture(scene, {188, 188, 188, 255}, {188, 188, 188, 255});
    const ShadingPlan plan = makePlan(scene, settings());
    EXPECT_FALSE(planned(plan).baseColor.used());
    // ((188/255 + 0.055) / 1.055)^2.4
    EXPECT_NEAR(planned(plan).baseColorFactor.r, 0.50288646, 1e-7);
    EXPECT_FALSE(plan.batches[0].key.baseColor.used);
}

TEST(MaterialPlan, AVaryingColourStays)
{
    Scene scene = sceneWith({});
    scene.materials[0].baseColor = addTexture(scene, {188, 188, 188, 255}, {187, 188, 188, 255});
    const ShadingPlan plan = makePlan(scene, settings());
    EXPECT_TRUE(plan.batches[0].key.baseColor.used);
    EXPECT_EQ(plan.batches[0].textures[0], 0);
}

TEST(MaterialPlan, AlphaOfAnOpaqueMaterialDoesNotCount)
{
    Scene scene = sceneWith({});
    scene.materials[0].baseColor = addTexture(scene, {10, 10, 10, 0}, {10, 10, 10, 255});
    EXPECT_FALSE(makePlan(scene, settings()).batches[0].key.baseColor.used);
    scene.materials[0].alphaMode = AlphaMode::mask;
    EXPECT_TRUE(makePlan(scene, settings()).batches[0].key.baseColor.used);
}

TEST(MaterialPlan, ABlendWithoutTransparencyIsOpaque)
{
    Scene scene = sceneWith({.alphaMode = AlphaMode::blend});
    scene.materials[0].baseColor = addTexture(scene, {1, 2, 3, 255}, {4, 5, 6, 255});
    const ShadingPlan opaque = makePlan(scene, settings());
    EXPECT_TRUE(opaque.blended.empty());
    EXPECT_EQ(opaque.batches.size(), 1u);
    scene.materials[0].baseColorFactor.a = 0.5;
    const ShadingPlan blended = makePlan(scene, settings());
    EXPECT_EQ(blended.blended.size(), 1u);
    EXPECT_TRUE(blended.batches.empty());
}

TEST(MaterialPlan, AMaskThatNothingFallsBelowIsOpaque)
{
    Scene scene = sceneWith({.alphaMode = AlphaMode::mask, .alphaCutoff = 0.5});
    scene.materials[0].baseColor = addTexture(scene, {0, 0, 0, 128}, {9, 9, 9, 255});
    EXPECT_EQ(makePlan(scene, settings()).batches[0].key.alphaMode, AlphaMode::opaque);
    scene.materials[0].alphaCutoff = 0.51;
    EXPECT_EQ(makePlan(scene, settings()).batches[0].key.alphaMode, AlphaMode::mask);
}

TEST(MaterialPlan, FlatNormalMapsGo)
{
    Scene scene = sceneWith({});
    scene.materials[0].normal = addTexture(scene, {128, 127, 255, 255}, {127, 128, 255, 255});
    EXPECT_FALSE(makePlan(scene, settings()).batches[0].key.normal.used);
    scene.materials[0].normal = addTexture(scene, {128, 129, 255, 255}, {127, 128, 255, 255});
    EXPECT_TRUE(makePlan(scene, settings()).batches[0].key.normal.used);
    scene.materials[0].normalScale = 0.0;
    EXPECT_FALSE(makePlan(scene, settings()).batches[0].key.normal.used);
}

TEST(MaterialPlan, BlackEmissionAndOpenOcclusionGo)
{
    Scene scene = sceneWith({.emissiveFactor = dvec3(1.0)});
    scene.materials[0].emissive = addTexture(scene, {0, 0, 0, 255}, {0, 0, 0, 255});
    scene.materials[0].occlusion = addTexture(scene, {255, 0, 0, 0}, {255, 9, 9, 9});
    const ShadingPlan plan = makePlan(scene, settings());
    EXPECT_FALSE(plan.batches[0].key.emissive.used);
    EXPECT_EQ(planned(plan).emissiveFactor, dvec3(0.0));
    EXPECT_FALSE(plan.batches[0].key.occlusion.used);
}

TEST(MaterialPlan, ConstantRoughnessAndMetalBecomeFactors)
{
    Scene scene = sceneWith({.metallicFactor = 0.5, .roughnessFactor = 1.0});
    scene.materials[0].metallicRoughness = addTexture(scene, {1, 51, 102, 0}, {200, 51, 102, 9});
    const ShadingPlan plan = makePlan(scene, settings());
    EXPECT_FALSE(plan.batches[0].key.material.used);
    EXPECT_DOUBLE_EQ(planned(plan).roughnessFactor, 51.0 / 255.0);
    EXPECT_DOUBLE_EQ(planned(plan).metallicFactor, 0.5 * 102.0 / 255.0);
}

TEST(MaterialPlan, UnlitLooksAtBaseColourOnly)
{
    Scene scene = sceneWith({.emissiveFactor = dvec3(1.0), .unlit = true});
    scene.materials[0].normal = addTexture(scene, {10, 20, 255, 255}, {127, 128, 255, 255});
    const ShadingPlan plan = makePlan(scene, settings("standard"));
    EXPECT_FALSE(plan.batches[0].key.normal.used);
    EXPECT_EQ(planned(plan).emissiveFactor, dvec3(0.0));
    EXPECT_FALSE(plan.batches[0].key.compensates);
    EXPECT_FALSE(plan.dfgTable);
}

TEST(MaterialPlan, EveryDecisionHasAReason)
{
    Scene scene = sceneWith({.name = "Label"});
    scene.materials[0].occlusion = addTexture(scene, {255, 0, 0, 0}, {255, 9, 9, 9});
    const std::string text = explain(makePlan(scene, settings()));
    EXPECT_NE(text.find("material 'Label': no occlusion texture (all its texels are 1)"), std::string::npos) << text;
}

} // namespace
} // namespace torrance
