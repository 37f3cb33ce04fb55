// The trials of torrance stability SCENE, on the device.
#include "gpu/test_device.h"
#include "passes/renderer.h"
#include "scene/camera_fit.h"
#include "study/analytic_scenes.h"
#include "study/scene_trials.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

std::vector<SceneTrial> tried(const Material& material)
{
    Subject subject = {.scene = shapeScene(AnalyticShape::Kind::sphere, material), .camera = {}};
    subject.scene.environment = uniformEnvironment(dvec3(0.7, 0.5, 0.3));
    subject.scene.lights = {testLight(Light::Kind::point), testLight(Light::Kind::spot)};
    subject.camera = fitCamera(subject.scene, OrbitAngles(), 1.0, 0.8, 0.05);
    Settings settings;
    settings.methods = *brdf::findPreset("standard");
    settings.width = settings.height = 96;
    settings.background = BackgroundKind::transparent;
    Renderer renderer(test::device(), test::shaders(), {});
    return runSceneTrials(
        subject,
        [&](const Scene& scene, const Camera& camera) {
            const ShadingPlan plan = makePlan(scene, settings);
            return renderer.render(renderer.upload(scene, plan), camera).color;
        },
        [](int, int) {});
}

TEST(SceneStability, HoldsForARoughHalfMetal)
{
    for (const SceneTrial& trial : tried(plainMaterial(dvec3(0.9, 0.5, 0.2), 0.5, 0.6)))
        EXPECT_TRUE(trial.passed()) << trial.name << ": " << trial.measured << " " << trial.quantity;
}

TEST(SceneStability, HoldsForASmoothDielectric)
{
    for (const SceneTrial& trial : tried(plainMaterial(dvec3(0.2, 0.5, 0.9), 0.0, 0.05)))
        EXPECT_TRUE(trial.passed()) << trial.name << ": " << trial.measured << " " << trial.quantity;
}

} // namespace
} // namespace torrance
