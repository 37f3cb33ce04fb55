// Which plans a scene's chart draws.
#include "study/plan_variants.h"

#include "study/analytic_scenes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace torrance {
namespace {

using brdf::Slot;

Settings standard()
{
    Settings settings;
    settings.methods = *brdf::findPreset("standard");
    return settings;
}

/// A sphere in the light of a lamp and of an even sky.
Scene plainScene()
{
    Scene scene = shapeScene(AnalyticShape::Kind::sphere, plainMaterial(dvec3(0.5), 0.0, 0.5));
    scene.lights.emplace_back();
    scene.environment = uniformEnvironment(dvec3(1.0));
    return scene;
}

std::size_t ofSlot(const Scene& scene, Slot slot)
{
    return static_cast<std::size_t>(
        std::ranges::count(planVariants(scene, standard()), std::string(brdf::slotName(slot)), &PlanVariant::kind));
}

TEST(PlanVariants, SlotsAreVariedWhereTheSceneHasWhatTheyAreAbout)
{
    Scene scene = plainScene();
    EXPECT_GT(ofSlot(scene, Slot::environmentSpecular), 0u);
    EXPECT_EQ(ofSlot(scene, Slot::textureFilter), 0u);
    EXPECT_EQ(ofSlot(scene, Slot::areaLight), 0u);
    EXPECT_EQ(ofSlot(scene, Slot::model), 0u);
    scene.textures.emplace_back();
    EXPECT_EQ(ofSlot(scene, Slot::textureFilter), 3u) << "all but the one that is drawn anyway";
    scene.lights.back().kind = Light::Kind::point;
    scene.lights.back().radius = 0.1;
    EXPECT_EQ(ofSlot(scene, Slot::areaLight), 2u);
    EXPECT_EQ(ofSlot(scene, Slot::pixelSampling), 0u) << "a choice beside a number of samples";
}

TEST(PlanVariants, EachMethodDiffersFromTheBaseInItsSlotAlone)
{
    Scene scene = plainScene();
    scene.textures.emplace_back();
    const Settings base = standard();
    const std::vector<PlanVariant> variants = planVariants(scene, base);
    EXPECT_EQ(variants.front().name, kStandardPlan);
    for (const PlanVariant& variant : variants)
        for (const Slot slot : brdf::allSlots())
            if (const auto varied = brdf::findSlot(variant.kind)) {
                EXPECT_EQ(variant.settings.methods[slot] == base.methods[slot], slot != *varied)
                    << variant.name << ", " << brdf::slotName(slot);
            }
}

} // namespace
} // namespace torrance
