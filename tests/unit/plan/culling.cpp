#include "plan/culling_plan.h"

#include "scenes.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

using test::sceneWith;
using test::settings;

/// One mesh of so many triangles.
Scene sceneOf(std::size_t triangles)
{
    Scene scene = sceneWith({});
    scene.primitives[0].indices.clear();
    for (std::size_t i = 0; i < triangles; ++i)
        scene.primitives[0].indices.insert(scene.primitives[0].indices.end(), {0, 1, 2});
    return scene;
}

Settings sized(int side)
{
    Settings s = settings();
    s.width = s.height = side;
    return s;
}

bool culls(const Scene& scene, const Settings& s)
{
    const ShadingPlan plan = makePlan(scene, s);
    const bool found = plan.batches.at(0).draws.at(0).culls;
    EXPECT_EQ(explain(plan).find("show at no pixel's centre") != std::string::npos, found);
    return found;
}

TEST(CullingPlan, LooksAtTrianglesThatAreManyForThePicture)
{
    EXPECT_TRUE(culls(sceneOf(1024), sized(256))); // 1/64 a pixel
    EXPECT_FALSE(culls(sceneOf(1023), sized(256)));
}

TEST(CullingPlan, LeavesSmallInstancesTogether)
{
    Scene scene = sceneOf(255);
    scene.instances.assign(100, Instance{});
    EXPECT_FALSE(culls(scene, sized(16)));
    EXPECT_TRUE(culls(sceneOf(256), sized(16)));
}

TEST(CullingPlan, KeepsToTheSettings)
{
    Settings s = sized(256);
    s.triangleCulling = true;
    EXPECT_TRUE(culls(sceneOf(1), s));
    s.triangleCulling = false;
    EXPECT_FALSE(culls(sceneOf(2000), s));
}

TEST(CullingPlan, IsOfOpaqueAndMaskedTriangles)
{
    Settings s = sized(16);
    s.triangleCulling = true;
    Scene scene = sceneOf(2000);
    scene.materials[0].alphaMode = AlphaMode::blend;
    scene.materials[0].baseColorFactor.a = 0.5;
    const ShadingPlan blended = makePlan(scene, s);
    EXPECT_FALSE(blended.blended.at(0).draws.at(0).culls);
    scene.materials[0].alphaMode = AlphaMode::mask;
    scene.materials[0].alphaCutoff = 0.4;
    EXPECT_TRUE(culls(scene, s));
    scene.materials[0].alphaMode = AlphaMode::opaque;
    scene.primitives[0].topology = Topology::lines;
    scene.primitives[0].indices.resize(4000);
    EXPECT_FALSE(culls(scene, s));
}

// A frame's indices must fit into memory, however many instances there are.
TEST(CullingPlan, HasRoomForSixteenMillionTriangles)
{
    Scene scene = sceneOf(1 << 14);
    scene.instances.assign(1 << 10, Instance{});
    EXPECT_TRUE(culls(scene, sized(256)));
    scene.instances.push_back(Instance{});
    EXPECT_FALSE(culls(scene, sized(256)));
}

} // namespace
} // namespace torrance
