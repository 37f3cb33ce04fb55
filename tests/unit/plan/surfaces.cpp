#include "core/error.h"
#include "scenes.h"

#include <gtest/gtest.h>
#include <set>

namespace torrance {
namespace {

using test::sceneWith;
using test::settings;

Light light(Light::Kind kind, double intensity)
{
    return {.name = "light", .kind = kind, .intensity = intensity};
}

TEST(SurfacePlan, InstancesOfOnePrimitiveAreOneDraw)
{
    Scene scene = sceneWith({});
    scene.instances.assign(1000, Instance{});
    const ShadingPlan plan = makePlan(scene, settings());
    ASSERT_EQ(plan.batches.size(), 1u);
    ASSERT_EQ(plan.batches[0].draws.size(), 1u);
    EXPECT_EQ(plan.batches[0].draws[0].instanceCount, 1000);
}

TEST(SurfacePlan, MirroredInstancesAreDrawnApart)
{
    Scene scene = sceneWith({});
    Instance mirrored;
    mirrored.worldFromObject[0][0] = -1.0;
    scene.instances.push_back(mirrored);
    const ShadingPlan plan = makePlan(scene, settings());
    ASSERT_EQ(plan.batches[0].draws.size(), 2u);
    EXPECT_NE(plan.batches[0].draws[0].mirrored, plan.batches[0].draws[1].mirrored);
}

TEST(SurfacePlan, ATextureWithoutCoordinatesIsLeftOut)
{
    Scene scene = sceneWith({});
    scene.materials[0].baseColor = test::addTexture(scene, {1, 2, 3, 4}, {5, 6, 7, 8});
    scene.materials[0].baseColor.uvSet = 1;
    EXPECT_FALSE(makePlan(scene, settings()).batches[0].key.baseColor.used);
    scene.primitives[0].uvs[1] = scene.primitives[0].uvs[0];
    EXPECT_TRUE(makePlan(scene, settings()).batches[0].key.baseColor.used);
}

TEST(SurfacePlan, TexturesReadAtOnePlaceHaveTheSameShadersWhereverItIs)
{
    Scene scene = sceneWith({});
    Material& m = scene.materials[0];
    m.baseColor = test::addTexture(scene, {1, 2, 3, 4}, {5, 6, 7, 8});
    m.normal = test::addTexture(scene, {10, 20, 255, 0}, {127, 128, 200, 0});
    scene.primitives[0].uvs[1] = scene.primitives[0].uvs[0];
    const auto textOf = [](const ShadingPlan& plan) { return selectedText(plan, plan.batches[0].key); };
    const ShadingPlan first = makePlan(scene, settings());
    EXPECT_TRUE(first.batches[0].key.onePlace);
    EXPECT_EQ(first.batches[0].draws[0].uvSet, 0);
    for (TextureUse* use : {&m.baseColor, &m.normal}) {
        use->uvSet = 1;
        use->transform[0][0] = 2.0;
    }
    m.doubleSided = true;
    const ShadingPlan second = makePlan(scene, settings());
    EXPECT_EQ(textOf(first), textOf(second));
    EXPECT_EQ(second.batches[0].draws[0].uvSet, 1);
    m.normal.uvSet = 0; // a place of its own
    const ShadingPlan apart = makePlan(scene, settings());
    EXPECT_FALSE(apart.batches[0].key.onePlace);
    EXPECT_NE(textOf(first), textOf(apart));
}

TEST(SurfacePlan, PointsWithoutNormalsAreUnlit)
{
    Scene scene = sceneWith({});
    scene.primitives[0].topology = Topology::points;
    scene.primitives[0].normals.clear();
    scene.lights = {light(Light::Kind::directional, 1.0)};
    const ShadingPlan plan = makePlan(scene, settings());
    EXPECT_TRUE(plan.lights.empty()) << "no surface is lit";
    EXPECT_EQ(selectedText(plan, plan.batches[0].key).find("#define LIT"), std::string::npos);
}

TEST(SurfacePlan, LightsThatCannotBeSeenGo)
{
    Scene scene = sceneWith({});
    Light far = light(Light::Kind::point, 5.0);
    far.position = dvec3(0, 0, 10);
    far.range = 9.99; // the triangle lies in z = 0
    Light near = far;
    near.range = 10.01;
    scene.lights = {light(Light::Kind::spot, 1.0), far, near, light(Light::Kind::directional, 0.0),
                    light(Light::Kind::directional, 2.0)};
    const ShadingPlan plan = makePlan(scene, settings());
    EXPECT_EQ(plan.lightCounts, (std::array<int, 3>{1, 1, 1}));
    ASSERT_EQ(plan.lights.size(), 3u);
    EXPECT_EQ(plan.lights[0].kind, Light::Kind::directional);
    EXPECT_EQ(plan.lights[1].range, 10.01);
}

TEST(SurfacePlan, AnEnvironmentThatNothingNeedsIsNotPrepared)
{
    Scene scene = sceneWith({.unlit = true});
    scene.environment = Environment{.radiance = Image(2, 1, 3, 1.0f)};
    Settings transparent = settings();
    transparent.background = BackgroundKind::transparent;
    const ShadingPlan plan = makePlan(scene, transparent);
    EXPECT_FALSE(plan.environmentLight);
    EXPECT_FALSE(plan.panorama);
    EXPECT_FALSE(plan.dfgTable);
    scene.materials[0].unlit = false;
    EXPECT_TRUE(makePlan(scene, transparent).environmentLight);
    EXPECT_TRUE(makePlan(scene, settings()).panorama);
}

TEST(SurfacePlan, ALobeWithoutATableIsRefusedWhereItNeedsOne)
{
    Scene scene = sceneWith({});
    Settings beckmann = settings();
    beckmann.methods.distribution = brdf::findMethod(brdf::Slot::distribution, "beckmann");
    scene.lights = {light(Light::Kind::directional, 1.0)};
    EXPECT_NO_THROW(makePlan(scene, beckmann)) << "a punctual light evaluates the lobe itself";
    Settings scaled = beckmann;
    scaled.methods.diffuseWeight = brdf::findMethod(brdf::Slot::diffuseWeight, "albedo_scaling");
    EXPECT_THROW(makePlan(scene, scaled), Error) << "its weight is the albedo of another lobe";
    scene.environment = Environment{.radiance = Image(2, 1, 3, 1.0f)};
    EXPECT_THROW(makePlan(scene, beckmann), Error);
    beckmann.methods.distribution = brdf::findMethod(brdf::Slot::distribution, "ggx_aniso");
    EXPECT_NO_THROW(makePlan(scene, beckmann)) << "without anisotropy it is ggx";
}

TEST(SurfacePlan, SaysWhichTermsOfTheEnvironmentAreNotTheChosenOnes)
{
    Scene scene = sceneWith({});
    scene.environment = Environment{.radiance = Image(2, 1, 3, 1.0f)};
    Settings chosen = settings();
    EXPECT_EQ(explain(makePlan(scene, chosen)).find("Schlick"), std::string::npos);
    chosen.methods.fresnel = brdf::findMethod(brdf::Slot::fresnel, "sg");
    chosen.methods.diffuse = brdf::findMethod(brdf::Slot::diffuse, "chan");
    const std::string text = explain(makePlan(scene, chosen));
    EXPECT_NE(text.find("its Fresnel term is Schlick's (sg has no table)"), std::string::npos) << text;
    EXPECT_NE(text.find("its diffuse light is Lambert's (chan has no table)"), std::string::npos) << text;
}

TEST(SurfacePlan, DifferentKeysHaveDifferentTexts)
{
    std::set<std::string> texts, names;
    const ShadingPlan plan = makePlan(sceneWith({}), settings("standard"));
    int count = 0;
    for (const bool colors : {false, true})
        for (const bool compensates : {false, true})
            for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend})
                for (const int uv : {0, 1}) {
                    const ShaderKey key = {.colors = colors,
                                           .baseColor = {.used = true, .uvSet = uv},
                                           .alphaMode = mode,
                                           .compensates = compensates};
                    texts.insert(selectedText(plan, key));
                    names.insert(key.name());
                    ++count;
                }
    EXPECT_EQ(texts.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(count));
}

TEST(SurfacePlan, TheSameSceneGivesTheSamePlan)
{
    const Scene scene = sceneWith({.name = "a"});
    EXPECT_EQ(explain(makePlan(scene, settings())), explain(makePlan(scene, settings())));
}

} // namespace
} // namespace torrance
