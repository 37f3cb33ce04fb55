#include "study/scene_trials.h"

#include "scene/camera_fit.h"
#include "study/analytic_scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

Subject sphere()
{
    Subject subject = {.scene = shapeScene(AnalyticShape::Kind::sphere, plainMaterial(dvec3(0.5), 0.0, 0.5)),
                       .camera = {}};
    subject.scene.environment = uniformEnvironment(dvec3(1.0));
    subject.camera = fitCamera(subject.scene, OrbitAngles(), 1.0, 0.8, 0.05);
    return subject;
}

// A renderer of one colour, which `colour` computes from what it is to draw.
DrawScene plain(const std::function<float(const Scene&, const Camera&)>& colour)
{
    return [colour](const Scene& scene, const Camera& camera) { return Image(8, 8, 4, colour(scene, camera)); };
}

const SceneTrial& named(const std::vector<SceneTrial>& trials, std::string_view name)
{
    const auto found = std::ranges::find(trials, name, &SceneTrial::name);
    EXPECT_NE(found, trials.end()) << name;
    return *found;
}

std::vector<SceneTrial> tried(const std::function<float(const Scene&, const Camera&)>& colour)
{
    return runSceneTrials(sphere(), plain(colour), [](int, int) {});
}

TEST(SceneTrials, PassForAPictureThatNothingChanges)
{
    const std::vector<SceneTrial> trials = tried([](const Scene&, const Camera&) { return 0.5f; });
    for (const SceneTrial& trial : trials)
        EXPECT_TRUE(trial.passed()) << trial.name;
    EXPECT_FALSE(named(trials, "mirrored texture coordinates").applies);
    EXPECT_FALSE(named(trials, "occlusion strength").applies);
}

// A renderer that forgets that candela are squared lengths; one whose world is float; one that mixes the roots.
TEST(SceneTrials, FailWhereTheRendererDoes)
{
    const auto scale = tried([](const Scene& scene, const Camera&) {
        return static_cast<float>(1 + glm::length(dvec3(scene.shapes.front().worldFromObject[0])));
    });
    EXPECT_FALSE(named(scale, "scale 1e+06").passed());
    EXPECT_TRUE(named(scale, "everything moved by 1e6 m").passed());

    const auto world = tried([](const Scene& scene, const Camera& camera) {
        const vec3 eye = vec3(dvec3(camera.worldFromCamera[3]));
        return 1 + glm::length(vec3(dvec3(scene.shapes.front().worldFromObject[3])) - eye);
    });
    EXPECT_FALSE(named(world, "everything moved by 1e6 m").passed());

    const auto mixed = tried([](const Scene& scene, const Camera&) {
        return static_cast<float>(1 + std::sqrt(scene.materials.front().metallicFactor));
    });
    EXPECT_FALSE(named(mixed, "metallic between 0 and 1").passed());
}

// A renderer that is brighter without an interface than with one.
TEST(SceneTrials, FailWhereNoInterfaceReflectsMoreThanGlass)
{
    const auto inverted =
        tried([](const Scene& scene, const Camera&) { return static_cast<float>(1 / scene.materials.front().ior); });
    EXPECT_FALSE(named(inverted, "index of refraction 1").passed());
    const auto rising =
        tried([](const Scene& scene, const Camera&) { return static_cast<float>(scene.materials.front().ior); });
    EXPECT_TRUE(named(rising, "index of refraction 1").passed());
}

TEST(SceneTrials, FailForPixelsThatAreNotFiniteOrNegative)
{
    for (const float bad : {NAN, INFINITY, -1.0f}) {
        const auto trials = tried([bad](const Scene& scene, const Camera&) {
            return scene.materials.front().roughnessFactor == 0 ? bad : 0.5f;
        });
        EXPECT_FALSE(named(trials, "roughness 0, spot light").passed()) << bad;
        EXPECT_TRUE(named(trials, "as it is").passed());
    }
    const auto bright = tried([](const Scene& scene, const Camera&) {
        return scene.environment && scene.environment->name == "spot" ? 1e7f : 0.5f;
    });
    EXPECT_FALSE(named(bright, "environment with one texel of 1e6").passed());
}

// A stripe of a pixel's width that comes and goes.
TEST(SceneTrials, SparkleIsAValueThatNoNeighbourHas)
{
    const Subject subject = sphere();
    const DrawScene draw = [&](const Scene&, const Camera& camera) {
        Image image(8, 8, 4, 1.0f);
        if (camera.worldFromCamera != subject.camera.worldFromCamera)
            std::fill_n(image.at(0, 4), 32, 3.0f); // a row
        return image;
    };
    const SceneTrial trial = named(runSceneTrials(subject, draw, [](int, int) {}), "camera moved by parts of a pixel");
    EXPECT_EQ(trial.measured, 8.0 / 64);
    EXPECT_FALSE(trial.passed());
}

TEST(SceneChanges, MirroringTwiceIsNothing)
{
    Scene scene;
    Primitive primitive;
    primitive.uvs[0] = {{0.25f, 0.5f}, {1.0f, 0.0f}};
    primitive.tangents = {{1, 0, 0, 1}, {0, 1, 0, -1}};
    scene.primitives = {primitive};
    TextureImage image = {.name = "n", .width = 3, .height = 1, .format = TexelFormat::rgba8, .texels = {}};
    for (int i = 0; i < 12; ++i)
        image.texels.push_back(static_cast<std::byte>(20 * i));
    scene.images = {image};
    scene.textures = {Texture{.image = 0, .sampler = {}}};
    Material material;
    material.normal.texture = 0;
    material.normal.transform = {0.5, 0.25, -0.25, 2.0, 0.125, 0.75};
    scene.materials = {material};

    Scene mirrored = scene;
    ASSERT_TRUE(mirrorUvs(mirrored));
    // The texel that a coordinate meets is the same one: T' (1 - u, v) = (1 - u', v').
    const glm::dvec2 before = material.normal.transform * dvec3(0.25, 0.5, 1);
    const glm::dvec2 after = mirrored.materials[0].normal.transform * dvec3(0.75, 0.5, 1);
    EXPECT_NEAR(after.x, 1 - before.x, 1e-15);
    EXPECT_NEAR(after.y, before.y, 1e-15);
    EXPECT_EQ(mirrored.images[0].texels[8], static_cast<std::byte>(255 - 0)) << "x of the first texel, negated";
    EXPECT_EQ(mirrored.images[0].texels[9], static_cast<std::byte>(20)) << "y as it was";
    EXPECT_EQ(mirrored.primitives[0].tangents[0], vec4(-1, 0, 0, -1));

    ASSERT_TRUE(mirrorUvs(mirrored));
    EXPECT_EQ(mirrored.images[0].texels, scene.images[0].texels);
    EXPECT_EQ(mirrored.primitives[0].uvs[0], primitive.uvs[0]);
    EXPECT_EQ(mirrored.materials[0].normal.transform, material.normal.transform);

    scene.materials[0].baseColor.texture = 0;
    EXPECT_FALSE(mirrorUvs(scene)) << "one picture cannot be mirrored for both";
}

TEST(SceneChanges, ScalingKeepsTheLightOfPointLights)
{
    Subject subject = sphere();
    subject.scene.lights = {testLight(Light::Kind::point), testLight(Light::Kind::directional)};
    const Subject large = scaled(subject, 100);
    const auto received = [](const Subject& s) {
        const dvec3 to = s.scene.lights[0].position - dvec3(s.scene.shapes[0].worldFromObject[3]);
        return s.scene.lights[0].intensity / glm::dot(to, to);
    };
    EXPECT_NEAR(received(large) / received(subject), 1.0, 1e-12);
    EXPECT_EQ(large.scene.lights[1].intensity, subject.scene.lights[1].intensity);
    EXPECT_EQ(large.camera.nearPlane, 100 * subject.camera.nearPlane);
}

} // namespace
} // namespace torrance
