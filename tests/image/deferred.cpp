// The deferred path draws the forward path's picture: |deferred - forward| <= 1e-5 |forward| + what the rounding of a
// pixel's own inputs may change.
#include "drawing.h"
#include "reference/pixel_condition.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "study/shape_cases.h"
#include "two_paths.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr double kRelative = 1e-5;
/// As the shapes' own tests have it: inputs are rounded once on the way in and once on the way through.
constexpr double kConditionFactor = 2.0;

void expectSameOnBothPaths(const Scene& scene, const Camera& camera, Settings settings, const std::string& name,
                           const Allowance& allowance = {})
{
    settings.path = RenderPath::deferred;
    expectForwardPicture(scene, camera, settings, name, kRelative, allowance);
}

// A shape's view direction is the pixel's ray on the forward path and comes from the stored position on the other.
void expectShapeSameOnBothPaths(const PictureCase& c)
{
    const auto allowance = [&](int x, int y) {
        const PixelInputs inputs = pixelInputs(c.scene, 0, c.camera, c.settings.width, c.settings.height, x, y);
        return coverageIsDecided(inputs) ? kConditionFactor * pixelCondition(c.settings.methods, inputs)
                                         : dvec3(0.0); // both paths round alike: they agree on what is covered
    };
    expectSameOnBothPaths(c.scene, c.camera, c.settings, c.name, allowance);
}

TEST(Deferred, AnalyticShapesAreTheForwardPicture)
{
    for (const auto shape : {AnalyticShape::Kind::sphere, AnalyticShape::Kind::plane})
        for (const auto light : {Light::Kind::directional, Light::Kind::point, Light::Kind::spot})
            for (const PictureCase& c : shapeCases(shape, light))
                if (c.settings.methods.id == "gltf") // what compensation adds is drawn below, for its kappa is costly
                    expectShapeSameOnBothPaths(c);
}

// Source C, whose path this is.
TEST(Deferred, SourceCIsItsForwardPicture)
{
    for (const PictureCase& c : presetSpheres(*brdf::findPreset("schlick-beckmann")))
        expectShapeSameOnBothPaths(c);
    Scene scene = texturedTorus();
    scene.lights = {testLight(Light::Kind::directional), testLight(Light::Kind::point), testLight(Light::Kind::spot)};
    expectSameOnBothPaths(scene, fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05), settingsOf("schlick-beckmann", 96),
                          "schlick-beckmann torus");
}

// What those of source B read of an environment: a table and levels, or the panorama itself.
TEST(Deferred, SourceBInAnEnvironmentIsItsForwardPicture)
{
    Scene scene = texturedTorus();
    scene.lights = {testLight(Light::Kind::directional)};
    scene.environment = uniformEnvironment(dvec3(1.0, 0.9, 0.8));
    for (const char* preset : {"ggx-burley", "phong"})
        expectSameOnBothPaths(scene, fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05), settingsOf(preset, 64), preset);
}

TEST(Deferred, TexturedMeshIsTheForwardPicture)
{
    Scene scene = texturedTorus();
    scene.lights = {testLight(Light::Kind::directional), testLight(Light::Kind::point), testLight(Light::Kind::spot)};
    scene.environment = uniformEnvironment(dvec3(1.0, 0.9, 0.8));
    const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
    for (const char* preset : {"gltf", "standard"})
        expectSameOnBothPaths(scene, camera, settingsOf(preset, 96), preset);
    Settings settings = settingsOf("standard", 64);
    settings.samples = 4;
    settings.background = BackgroundKind::environment;
    expectSameOnBothPaths(scene, camera, settings, "four samples before a panorama");
}

TEST(Deferred, EveryKindOfSurfaceTogetherIsTheForwardPicture)
{
    const Scene scene = sceneOfAllSurfaces();
    Settings settings = settingsOf("standard", 96);
    settings.background = BackgroundKind::color;
    settings.backgroundColor = dvec3(0.05, 0.1, 0.15);
    for (const Camera& camera : {fitCamera(scene, {0.3, 1.3}, 1.0, 0.7, 0.05), orthographicCamera()})
        expectSameOnBothPaths(scene, camera, settings, "mixed");
}

TEST(Deferred, DemoSceneIsTheForwardPicture)
{
    const Scene scene = demoScene();
    Settings settings = settingsOf("standard", 192);
    settings.background = BackgroundKind::environment;
    expectSameOnBothPaths(scene, fitCamera(scene, {0.3, 1.2}, 1.0, 0.7, 0.05), settings, "demo");
}

TEST(Deferred, LeavesTheLayersAsTheyAre)
{
    const Scene scene = mixedScene();
    const Camera camera = fitCamera(scene, {0.3, 1.3}, 1.0, 0.7, 0.05);
    Settings settings = settingsOf("standard", 48);
    settings.layers = true;
    settings.path = RenderPath::forward;
    const Picture forward = draw(scene, camera, settings);
    settings.path = RenderPath::deferred;
    const Picture deferred = draw(scene, camera, settings);
    ASSERT_EQ(forward.layers.size(), deferred.layers.size());
    for (std::size_t i = 0; i < forward.layers.size(); ++i)
        EXPECT_EQ(forward.layers[i].image.texels, deferred.layers[i].image.texels) << forward.layers[i].name;
}

} // namespace
} // namespace torrance::test
