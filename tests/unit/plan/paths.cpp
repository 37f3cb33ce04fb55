#include "plan/path_plan.h"

#include "core/error.h"
#include "plan/attribute_plan.h"
#include "plan/light_plan.h"
#include "scenes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace torrance {
namespace {

using test::sceneWith;
using test::settings;

Scene litScene()
{
    Scene scene = sceneWith({});
    scene.lights = {Light{}};
    return scene;
}

Settings sized(int side)
{
    Settings s = settings("standard");
    s.width = s.height = side;
    return s;
}

TEST(PathPlan, ShadesOnlyWhatIsSeen)
{
    const ShadingPlan plan = makePlan(litScene(), sized(64));
    EXPECT_EQ(plan.path, RenderPath::prepass);
    EXPECT_NE(explain(plan).find("path: prepass"), std::string::npos);
    EXPECT_NE(explain(plan).find("surfaces: path prepass ("), std::string::npos);
}

TEST(PathPlan, LeavesAttributesWhereTrianglesAreManyForThePicture)
{
    Scene scene = litScene();
    scene.instances.assign(128, Instance{}); // of one triangle each: 1/32 a pixel
    EXPECT_EQ(makePlan(scene, sized(64)).path, RenderPath::attributes);
    scene.instances.resize(127);
    EXPECT_EQ(makePlan(scene, sized(64)).path, RenderPath::prepass);
}

TEST(PathPlan, CountsWhatCanLeaveAttributes)
{
    Scene scene = litScene();
    scene.instances.assign(4096, Instance{});
    scene.primitives[0].colors.assign(3, vec4(0.5f)); // shaded as they are drawn
    EXPECT_EQ(makePlan(scene, sized(64)).path, RenderPath::prepass);
}

TEST(PathPlan, DrawsForwardWhatHasNoLitMesh)
{
    Scene unlit = litScene();
    unlit.materials[0].unlit = true;
    EXPECT_EQ(makePlan(unlit, sized(64)).path, RenderPath::forward);
    Scene shape;
    shape.lights = {Light{}};
    shape.shapes.push_back({});
    EXPECT_EQ(makePlan(shape, sized(64)).path, RenderPath::forward);
}

TEST(PathPlan, KeepsToTheSettings)
{
    Settings s = sized(64);
    for (const RenderPath path : kRenderPaths) {
        s.path = path;
        const ShadingPlan plan = makePlan(litScene(), s);
        EXPECT_EQ(plan.path, path);
        EXPECT_NE(explain(plan).find(std::string("path: ") + nameOf(path)), std::string::npos);
    }
}

// How the normal turns is not kept, and a term is drawn by the surface itself.
TEST(PathPlan, TakesNoAttributesForWhatTheyCannotDraw)
{
    Scene scene = litScene();
    scene.instances.assign(4096, Instance{});
    for (Settings s : {sized(64), sized(64)}) {
        s.methods.specularAntialiasing = brdf::findMethod(brdf::Slot::specularAntialiasing, "tokuyoshi");
        EXPECT_EQ(makePlan(scene, s).path, RenderPath::prepass);
        s.path = RenderPath::attributes;
        EXPECT_THROW(makePlan(scene, s), Error);
    }
    Settings viewed = sized(64);
    viewed.view = findView("D");
    ASSERT_NE(viewed.view, nullptr);
    EXPECT_EQ(makePlan(scene, viewed).path, RenderPath::prepass);
}

TEST(AttributePlan, SharesClassesByShaderAndTextures)
{
    Scene scene = litScene();
    scene.materials.push_back({.roughnessFactor = 0.3});
    scene.materials.push_back({.doubleSided = true});
    scene.materials.push_back({.unlit = true});
    for (int i = 1; i < 4; ++i) {
        scene.primitives.push_back(test::triangle(i));
        scene.instances.push_back({.primitive = i});
    }
    Settings s = sized(64);
    s.path = RenderPath::attributes;
    const ShadingPlan plan = makePlan(scene, s);
    ASSERT_EQ(plan.classes.size(), 2u) << "lit and unlit";
    std::vector<std::size_t> sizes = {plan.classes[0].blocks.size(), plan.classes[1].blocks.size()};
    std::ranges::sort(sizes);
    EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 3}));
    for (const Batch& batch : plan.batches)
        EXPECT_GE(batch.shadingClass, 0);
}

TEST(AttributePlan, LeavesOutWhatItsPicturesCannotHold)
{
    Settings s = sized(64);
    s.path = RenderPath::attributes;
    Scene colored = litScene();
    colored.primitives[0].colors.assign(3, vec4(0.5f));
    EXPECT_TRUE(makePlan(colored, s).classes.empty());
    Scene turned = litScene(); // two places in textures
    turned.materials[0].baseColor = test::addTexture(turned, {1, 2, 3, 4}, {5, 6, 7, 8});
    turned.materials[0].normal = test::addTexture(turned, {10, 20, 255, 0}, {127, 128, 200, 0});
    EXPECT_EQ(makePlan(turned, s).classes.size(), 1u);
    turned.materials[0].normal.transform[0][0] = 2.0;
    EXPECT_TRUE(makePlan(turned, s).classes.empty());
}

TEST(AttributePlan, GivesEveryMaterialASlotAndNoClassTooMany)
{
    Scene scene = litScene();
    const int count = static_cast<int>(kMaxClassMaterials) + 10;
    scene.materials.clear();
    scene.primitives.clear();
    scene.instances.clear();
    for (int i = 0; i < count; ++i) {
        scene.materials.push_back({.roughnessFactor = 0.5 + 0.001 * i});
        scene.primitives.push_back(test::triangle(i));
        scene.instances.push_back({.primitive = i});
    }
    Settings s = sized(64);
    s.path = RenderPath::attributes;
    const ShadingPlan plan = makePlan(scene, s);
    ASSERT_EQ(plan.classes.size(), 2u);
    std::size_t blocks = 0;
    for (const ShadingClass& c : plan.classes) {
        EXPECT_LE(c.blocks.size(), kMaxClassMaterials);
        for (std::size_t i = 0; i < c.blocks.size(); ++i)
            EXPECT_EQ(plan.blocks[static_cast<std::size_t>(c.blocks[i])].slot, static_cast<int>(i));
        blocks += c.blocks.size();
    }
    EXPECT_EQ(blocks, static_cast<std::size_t>(count));
}

TEST(LightPlan, RefusesMoreThanABlockHolds)
{
    Scene scene = litScene();
    scene.lights.assign(kMostLights, Light{});
    EXPECT_EQ(makePlan(scene, sized(64)).lights.size(), kMostLights);
    scene.lights.push_back(Light{});
    try {
        makePlan(scene, sized(64));
        FAIL() << "planned";
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::input);
        EXPECT_NE(std::string(error.what()).find("1025 lights"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace torrance
