#include "plan/deferred_plan.h"

#include "core/error.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

Settings deferred()
{
    Settings s = settings("standard");
    s.path = RenderPath::deferred;
    return s;
}

/// Triangles of materials of each kind: lit twice (of different keys), compensated, unlit, blended.
Scene fiveSurfaces()
{
    Scene scene;
    Material lit = {.metallicFactor = 0.0, .roughnessFactor = 0.2};
    Material doubleSided = lit;
    doubleSided.doubleSided = true;
    Material metal = {.roughnessFactor = 1.0};
    Material unlit = lit;
    unlit.unlit = true;
    Material blended = unlit;
    blended.alphaMode = AlphaMode::blend;
    blended.baseColorFactor.a = 0.5;
    scene.materials = {lit, doubleSided, metal, unlit, blended};
    for (int i = 0; i < 5; ++i) {
        scene.primitives.push_back(triangle(i));
        scene.instances.push_back({.primitive = i});
    }
    scene.lights = {Light{}};
    return scene;
}

TEST(DeferredPlan, HasOneLightingPassForEachWayOfLighting)
{
    const ShadingPlan plan = makePlan(fiveSurfaces(), deferred());
    ASSERT_EQ(plan.lightingClasses.size(), 3u) << explain(plan);
    for (const Batch& batch : plan.batches) {
        const ShaderKey& found = plan.lightingClasses[lightingClassIndex(plan, batch.key)];
        EXPECT_EQ(found.unlit, batch.key.unlit);
        EXPECT_EQ(found.compensates, batch.key.compensates);
    }
    EXPECT_NE(explain(plan).find("path: deferred, 3 lighting passes"), std::string::npos);
    EXPECT_NE(explain(plan).find("blended surfaces: drawn forward over the rest"), std::string::npos);
}

TEST(DeferredPlan, ASurfaceWithoutNormalsIsLitLikeAnUnlitOne)
{
    ShaderKey key = {.surface = SurfaceKind::lines, .normals = false, .compensates = true};
    EXPECT_EQ(lightingClass(key), (ShaderKey{.unlit = true}));
    key.normals = true;
    EXPECT_EQ(lightingClass(key), (ShaderKey{.compensates = true}));
}

// In a lighting pass a pixel's neighbours may be of other surfaces: it knows no derivatives.
TEST(DeferredPlan, RefusesWhatReadsTheSurfaceAround)
{
    brdf::Method widening = *brdf::findMethod(brdf::Slot::specularAntialiasing, "none");
    widening.id = "widening";
    Settings s = deferred();
    s.methods.specularAntialiasing = &widening;
    try {
        makePlan(fiveSurfaces(), s);
        FAIL() << "planned";
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::usage);
        EXPECT_NE(std::string(error.what()).find("widening"), std::string::npos) << error.what();
    }
}

TEST(DeferredPlan, OtherPathsHaveNone)
{
    Settings s = settings("standard");
    for (const RenderPath path : {RenderPath::forward, RenderPath::prepass, RenderPath::attributes}) {
        s.path = path;
        const ShadingPlan plan = makePlan(fiveSurfaces(), s);
        EXPECT_TRUE(plan.lightingClasses.empty());
        EXPECT_EQ(plan.path, path);
        EXPECT_EQ(explain(plan).find("drawn forward over"), std::string::npos);
    }
}

} // namespace
} // namespace torrance::test
