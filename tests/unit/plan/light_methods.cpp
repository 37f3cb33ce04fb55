// Materials that compute light each in its own way: what the plan makes of them.
#include "plan/light_methods.h"

#include "core/error.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

LightMethods bounded(int samples)
{
    Settings own = settings("standard");
    own.methods.environmentSpecular = brdf::findMethod(brdf::Slot::environmentSpecular, "vndf_bounded");
    own.environmentSamples = samples;
    return lightMethodsOf(own);
}

/// Four triangles of four materials, the last of them unlit.
Scene four()
{
    Scene scene;
    scene.environment = Environment{.radiance = Image(2, 1, 3, 1.0f)};
    for (int i = 0; i < 4; ++i) {
        scene.materials.push_back({.unlit = i == 3});
        scene.primitives.push_back(triangle(i));
        scene.instances.push_back({.primitive = i});
    }
    return scene;
}

TEST(MaterialLight, IsPlannedOnceForAllThatAreLitAlike)
{
    Settings asked = settings("standard");
    asked.ofMaterials = {{0, bounded(16)}, {2, bounded(16)}, {3, bounded(32)}};
    const ShadingPlan plan = makePlan(four(), asked);
    ASSERT_EQ(plan.choices.size(), 2u) << "what is not lit has none";
    EXPECT_EQ(plan.choices[0].environmentSamples, 16);
    EXPECT_EQ(lightMethodsOf(plan.choices[1]), lightMethodsOf(settings("standard")));
    EXPECT_EQ(plan.batches.size(), 3u) << "materials 0 and 2 are drawn together";
    for (const Batch& batch : plan.batches) {
        const std::string text = selectedText(plan, batch.key);
        const bool samples = text.find("sample_vndf_bounded.glsl") != std::string::npos;
        EXPECT_EQ(samples, !batch.key.unlit && batch.key.choice == 0);
        EXPECT_EQ(text.find("choice"), std::string::npos) << "texts that differ in a comment are compiled twice";
    }
}

TEST(MaterialLight, TheDefaultMaterialsNumberIsBehindTheLast)
{
    Scene scene = four();
    scene.primitives[0].material = -1;
    Settings asked = settings("standard");
    asked.ofMaterials = {{4, bounded(16)}};
    EXPECT_EQ(makePlan(scene, asked).choices.size(), 2u);
    asked.ofMaterials = {{5, bounded(16)}};
    EXPECT_THROW(makePlan(scene, asked), Error);
}

TEST(MaterialLight, IsWrittenAsTheOptionTakesIt)
{
    EXPECT_EQ(materialMethodsText(7, bounded(16)),
              "7:environment-diffuse=irradiance_cube,environment-specular=vndf_bounded,"
              "dfg=table,area-light=point,environment-samples=16");
    EXPECT_EQ(materialMethodsText(0, lightMethodsOf(settings("phong"))),
              "0:environment-specular=mirror,area-light=point");
}

} // namespace
} // namespace torrance::test
