// The paths that shade only what is seen draw the forward path's picture: after a depth pass to the bit, from
// attributes as closely as what is rounded on the way allows.
#include "measure/image_metrics.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "two_paths.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace torrance::test {
namespace {

/// Attributes are kept in floats, but the tangent passes through its octahedron and the position through the depth: a
/// few roundings, which a highlight amplifies as it does those of the forward path's own.
constexpr double kAttributes = 2e-5;
/// Of whole pictures with mips: the device's own level, rounded to 2^-17, moves the weight between two levels by as
/// much, and where that turns a normal a highlight of a picture's worst pixel may double.
constexpr double kRelMse = 1e-6;

Scene litTorus()
{
    Scene scene = texturedTorus();
    scene.lights = {testLight(Light::Kind::directional), testLight(Light::Kind::point), testLight(Light::Kind::spot)};
    scene.environment = uniformEnvironment(dvec3(1.0, 0.9, 0.8));
    return scene;
}

Camera torusCamera(const Scene& scene)
{
    return fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
}

Settings on(RenderPath path, Settings settings)
{
    settings.path = path;
    return settings;
}

Settings beforeAColor(Settings settings)
{
    settings.background = BackgroundKind::color;
    settings.backgroundColor = dvec3(0.05, 0.1, 0.15);
    return settings;
}

Settings demoSettings()
{
    Settings settings = settingsOf("standard", 192);
    settings.background = BackgroundKind::environment;
    return settings;
}

void expectSameBytes(const Scene& scene, const Camera& camera, const Settings& settings, const char* name)
{
    const Picture forward = draw(scene, camera, on(RenderPath::forward, settings));
    const Picture prepass = draw(scene, camera, on(RenderPath::prepass, settings));
    EXPECT_TRUE(forward.color.texels == prepass.color.texels) << name;
}

TEST(Prepass, DrawsTheForwardPictureToTheBit)
{
    const Scene torus = litTorus();
    for (const char* preset : {"standard", "gltf", "phong"})
        expectSameBytes(torus, torusCamera(torus), settingsOf(preset, 96), preset);
    const Scene all = sceneOfAllSurfaces();
    const Settings settings = beforeAColor(settingsOf("standard", 96));
    expectSameBytes(all, fitCamera(all, {0.3, 1.3}, 1.0, 0.7, 0.05), settings, "perspective");
    expectSameBytes(all, orthographicCamera(), settings, "orthographic");
    const Scene demo = demoScene();
    Settings twoSamples = demoSettings();
    twoSamples.samples = 2;
    expectSameBytes(demo, fitCamera(demo, {0.3, 1.2}, 1.0, 0.7, 0.05), twoSamples, "demo");
}

TEST(Attributes, TexturedMeshIsTheForwardPicture)
{
    const Scene torus = litTorus();
    for (const char* preset : {"standard", "gltf", "phong", "ggx-burley", "schlick-beckmann"}) {
        Scene scene = torus;
        if (std::string(preset) == "schlick-beckmann")
            scene.environment.reset(); // defines no light from one
        expectForwardPicture(scene, torusCamera(scene), on(RenderPath::attributes, settingsOf(preset, 96)), preset,
                             kAttributes);
    }
    Settings settings = on(RenderPath::attributes, settingsOf("standard", 64));
    settings.samples = 4;
    settings.background = BackgroundKind::environment;
    expectForwardPicture(torus, torusCamera(torus), settings, "four samples before a panorama", kAttributes);
}

TEST(Attributes, EveryKindOfSurfaceTogetherIsTheForwardPicture)
{
    const Scene scene = sceneOfAllSurfaces();
    const Settings settings = on(RenderPath::attributes, beforeAColor(settingsOf("standard", 96)));
    for (const Camera& camera : {fitCamera(scene, {0.3, 1.3}, 1.0, 0.7, 0.05), orthographicCamera()})
        expectForwardPicture(scene, camera, settings, "mixed", kAttributes);
}

// The far sides of surfaces, instances that are mirrored, and materials that share a class.
TEST(Attributes, SidesAndSlotsAreTheForwardPictures)
{
    Scene scene;
    for (int i = 0; i < 4; ++i) {
        Material material =
            plainMaterial(dvec3(0.2 + 0.2 * i, 0.5, 0.8 - 0.2 * i), 0.0, 0.1 + 0.02 * i); // none compensated
        material.doubleSided = true;
        scene.materials.push_back(material);
        dmat4 place = translation(dvec3(2.2 * i, 0.0, 0.0));
        if (i % 2 == 1)
            place[0][0] = -1.0; // mirrored
        if (i >= 2)
            place[2][2] = -1.0;
        addInstance(scene, square(i), place);
    }
    scene.lights = {testLight(Light::Kind::directional)};
    scene.environment = uniformEnvironment(dvec3(0.3));
    const Settings settings = on(RenderPath::attributes, settingsOf("standard", 96));
    for (const double azimuth : {0.3, 2.8}) // before and behind
        expectForwardPicture(scene, fitCamera(scene, {azimuth, 1.3}, 1.0, 0.7, 0.05), settings, "sides", kAttributes);
    EXPECT_EQ(makePlan(scene, settings).classes.size(), 1u);
}

TEST(Attributes, MipsAreTheForwardPicturesAsAWhole)
{
    const Scene demo = demoScene();
    const Camera camera = fitCamera(demo, {0.3, 1.2}, 1.0, 0.7, 0.05);
    const Picture forward = draw(demo, camera, on(RenderPath::forward, demoSettings()));
    const Picture attributes = draw(demo, camera, on(RenderPath::attributes, demoSettings()));
    EXPECT_LE(compareImages(forward.color, attributes.color).relMse, kRelMse);
}

// Its level is told for all textures at once, and one that is magnified must not hold another's back.
TEST(Attributes, TexturesOfTwoSizesAreReadAtTheirOwnLevels)
{
    const auto waves = [](int side, int periods) {
        return makeTexels(side, side, TexelFormat::rgba8, [=](int x, int y) {
            const double phase = 2.0 * std::numbers::pi * periods / side;
            return dvec4(dvec2(0.5) + 0.4 * dvec2(std::sin(phase * x), std::sin(phase * y)), 0.5, 1.0);
        });
    };
    for (const bool largeFirst : {false, true}) {
        Scene scene;
        Material material = plainMaterial(dvec3(1.0), 0.0, 0.6);
        material.emissiveFactor = dvec3(1.0);
        TextureUse& large = largeFirst ? material.baseColor : material.emissive;
        TextureUse& small = largeFirst ? material.emissive : material.baseColor;
        small.texture = addTexture(scene, waves(8, 2), Sampler{});
        large.texture = addTexture(scene, waves(512, 8), Sampler{});
        scene.materials = {material};
        addInstance(scene, square(0), dmat4(1.0));
        scene.lights = {testLight(Light::Kind::directional)};
        const Camera camera = fitCamera(scene, {0.3, 1.3}, 1.0, 0.7, 0.05);
        const Settings settings = settingsOf("standard", 96);
        const Picture forward = draw(scene, camera, on(RenderPath::forward, settings));
        const Picture attributes = draw(scene, camera, on(RenderPath::attributes, settings));
        EXPECT_LE(compareImages(forward.color, attributes.color).relMse, kRelMse) << largeFirst;
    }
}

TEST(Attributes, LeaveTheLayersAsTheyAre)
{
    const Scene scene = mixedScene();
    const Camera camera = fitCamera(scene, {0.3, 1.3}, 1.0, 0.7, 0.05);
    Settings settings = settingsOf("standard", 48);
    settings.layers = true;
    const Picture forward = draw(scene, camera, on(RenderPath::forward, settings));
    const Picture attributes = draw(scene, camera, on(RenderPath::attributes, settings));
    ASSERT_EQ(forward.layers.size(), attributes.layers.size());
    for (std::size_t i = 0; i < forward.layers.size(); ++i)
        EXPECT_EQ(forward.layers[i].image.texels, attributes.layers[i].image.texels) << forward.layers[i].name;
}

} // namespace
} // namespace torrance::test
