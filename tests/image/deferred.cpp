// The deferred path draws the forward path's picture: |deferred - forward| <= 1e-5 |forward| + what the rounding of a
// pixel's own inputs may change.
#include "core/data_folder.h"
#include "drawing.h"
#include "files/environment_file.h"
#include "files/scene_file.h"
#include "reference/pixel_condition.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "study/shape_cases.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr double kRelative = 1e-5;
/// As the shapes' own tests have it: inputs are rounded once on the way in and once on the way through.
constexpr double kConditionFactor = 2.0;

using Allowance = std::function<dvec3(int x, int y)>;

/// Draws both ways; how much was lit, for a picture of nothing agrees with itself.
void expectSameOnBothPaths(
    const Scene& scene, const Camera& camera, Settings settings, const std::string& name,
    const Allowance& allowance = [](int, int) { return dvec3(0.0); })
{
    const Picture forward = draw(scene, camera, settings);
    settings.path = RenderPath::deferred;
    const Picture deferred = draw(scene, camera, settings);
    WorstExcess worst;
    int lit = 0;
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x) {
            const dvec4 f = pixelOf(forward, x, y), d = pixelOf(deferred, x, y);
            EXPECT_EQ(d.a, f.a) << name << " at " << x << ", " << y;
            lit += f.r + f.g + f.b > 0.0 ? 1 : 0;
            constexpr double kLeast = 1e-30; // black is allowed to be black
            worst.note(x, y, dvec3(d), dvec3(f), kRelative * glm::abs(dvec3(f)) + allowance(x, y) + kLeast);
        }
    EXPECT_GT(lit, settings.width * settings.height / 10) << name << ": hardly anything is lit";
    EXPECT_LE(worst.excess, 1.0) << name << ": " << worst.text();
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

/// Four squares side by side, each of a material and a kind of its own, and a blended one before them all.
Scene mixedScene()
{
    Scene scene;
    Material unlit = plainMaterial(dvec3(0.1, 0.2, 0.7), 0.0, 1.0);
    unlit.unlit = true;
    Material masked = plainMaterial(dvec3(0.9), 1.0, 0.9); // compensated
    masked.alphaMode = AlphaMode::mask;
    masked.alphaCutoff = 0.5;
    masked.doubleSided = true;
    masked.baseColor.texture = addTexture(
        scene, makeTexels(2, 2, TexelFormat::rgba8, [](int x, int y) { return dvec4(0.9, 0.8, 0.7, x == y); }),
        levelZero(Filter::nearest));
    Material blended = plainMaterial(dvec3(0.2, 0.9, 0.3), 0.0, 0.4);
    blended.alphaMode = AlphaMode::blend;
    blended.baseColorFactor.a = 0.4;
    scene.materials = {plainMaterial(dvec3(0.8, 0.3, 0.2), 0.0, 0.5), unlit, masked, blended};
    for (int i = 0; i < 3; ++i)
        addInstance(scene, square(i), translation(dvec3(2.2 * i, 0.0, 0.0)));
    addInstance(scene, square(3), translation(dvec3(2.2, -0.6, 0.5)));
    scene.lights = {testLight(Light::Kind::directional)};
    scene.environment = uniformEnvironment(dvec3(0.3));
    return scene;
}

/// A square of points or lines: lit where it has normals, drawn in its own colour where not.
void addThin(Scene& scene, Topology topology, bool normals, double x)
{
    Primitive p = square(0);
    p.topology = topology;
    p.tangents.clear();
    if (!normals)
        p.normals.clear();
    p.indices = {0, 1, 1, 2, 2, 3, 3, 0};
    addInstance(scene, std::move(p), translation(dvec3(x, 2.3, 0.0)));
}

TEST(Deferred, EveryKindOfSurfaceTogetherIsTheForwardPicture)
{
    Scene scene = mixedScene();
    addThin(scene, Topology::lines, true, 0.0);
    addThin(scene, Topology::lines, false, 2.2);
    addThin(scene, Topology::points, false, 4.4);
    Camera orthographic = orbitCamera({0.1, 1.4}, 8.0, dvec3(2.2, 0.8, 0.0), 0.7);
    orthographic.kind = Camera::Kind::orthographic;
    orthographic.ymag = 4.0;
    orthographic.nearPlane = 0.1;
    orthographic.farPlane = 20.0;
    Settings settings = settingsOf("standard", 96);
    settings.background = BackgroundKind::color;
    settings.backgroundColor = dvec3(0.05, 0.1, 0.15);
    for (const Camera& camera : {fitCamera(scene, {0.3, 1.3}, 1.0, 0.7, 0.05), orthographic})
        expectSameOnBothPaths(scene, camera, settings, "mixed");
}

TEST(Deferred, DemoSceneIsTheForwardPicture)
{
    Scene scene = loadScene(dataFolder() / "assets" / "demo" / "demo.gltf").scene;
    scene.environment = Environment{};
    scene.environment->radiance =
        loadEnvironment((dataFolder() / "assets" / "environments" / "studio.hdr").string()).radiance;
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
    const Picture forward = draw(scene, camera, settings);
    settings.path = RenderPath::deferred;
    const Picture deferred = draw(scene, camera, settings);
    ASSERT_EQ(forward.layers.size(), deferred.layers.size());
    for (std::size_t i = 0; i < forward.layers.size(); ++i)
        EXPECT_EQ(forward.layers[i].image.texels, deferred.layers[i].image.texels) << forward.layers[i].name;
}

} // namespace
} // namespace torrance::test
