#include "plan/level_plan.h"

#include "scene/camera_fit.h"
#include "scenes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

constexpr int kSide = 64; // of the picture, in pixels

/// A square of side 2 that faces the camera, with a colour of `texels` a side.
Scene squareScene(int texels)
{
    Scene scene;
    scene.materials = {Material{}};
    Primitive p;
    p.positions = {{-1, 1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, -1, 0}};
    p.normals.assign(4, vec3(0, 0, 1));
    p.uvs[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    p.indices = {0, 3, 2, 0, 2, 1};
    p.material = 0;
    p.boundsMin = dvec3(-1, -1, 0);
    p.boundsMax = dvec3(1, 1, 0);
    scene.primitives = {p};
    scene.instances = {Instance{}};
    TextureImage image{"colour", texels, texels, TexelFormat::rgba8, {}};
    image.texels.resize(static_cast<std::size_t>(texels) * static_cast<std::size_t>(texels) * 4);
    image.texels[0] = std::byte(255);
    scene.images.push_back(std::move(image));
    scene.textures.push_back({.image = 0});
    scene.materials[0].baseColor.texture = 0;
    return scene;
}

/// Sees `height` metres of what lies in the plane z = 0.
Camera orthographic(double height)
{
    Camera c = orbitCamera({0.0, std::acos(0.0)}, 5.0, dvec3(0.0), 0.7);
    c.kind = Camera::Kind::orthographic;
    c.ymag = height / 2.0;
    c.nearPlane = 0.1;
    c.farPlane = 10.0;
    return c;
}

Settings sized(int samples = 1)
{
    Settings s = test::settings("standard");
    s.width = s.height = kSide;
    s.samples = samples;
    return s;
}

int finest(const Scene& scene, const Camera& camera, int samples = 1)
{
    const ShadingPlan plan = makePlan(scene, sized(samples));
    const std::vector<int> levels = finestLevels(scene, plan, camera);
    EXPECT_EQ(levels.size(), 1u);
    return levels.empty() ? -1 : levels[0];
}

// The square fills the picture: a texture of 2^k times its side is read at level k, and what is not read is not kept. A
// quarter of a level is the margin.
TEST(LevelPlan, IsTheLevelThatAFrontalPictureReads)
{
    const Camera camera = orthographic(2.0);
    EXPECT_EQ(finest(squareScene(kSide), camera), 0);
    EXPECT_EQ(finest(squareScene(kSide * 4), camera), 1) << "level 2 exactly, less the margin";
    EXPECT_EQ(finest(squareScene(kSide * 4), orthographic(2.0 * std::exp2(0.3))), 2);
    EXPECT_EQ(finest(squareScene(kSide * 16), camera), 3);
}

TEST(LevelPlan, IsThatOfTheNearestPoint)
{
    // A perspective camera 5 m away sees 2 * 5 tan(0.35) = 3.65 m: 1024 texels over 2 m are 29.2 a pixel on the axis.
    const Camera frontal = orbitCamera({0.0, std::acos(0.0)}, 5.0, dvec3(0.0), 0.7);
    EXPECT_EQ(finest(squareScene(1024), frontal), 4);
    Scene tilted = squareScene(1024); // its nearest corner is 1.6 m before the camera: a third of it
    tilted.instances[0].worldFromObject =
        dmat4(dvec4(1, 0, 0, 0), dvec4(0, 0.1, 1, 0), dvec4(0, 1, -0.1, 0), dvec4(0, 0, 2.4, 1));
    EXPECT_LE(finest(tilted, frontal), 3);
    EXPECT_GE(finest(tilted, frontal), 2);
}

TEST(LevelPlan, FollowsTransformsOfTheCoordinates)
{
    Scene scene = squareScene(kSide * 4);
    scene.materials[0].baseColor.transform = glm::dmat3x2(0.25, 0, 0, 0.25, 0, 0); // a quarter of the texture
    EXPECT_EQ(finest(scene, orthographic(2.0)), 0);
}

TEST(LevelPlan, IsFinerForMoreSamples)
{
    const Camera camera = orthographic(2.0 * std::exp2(0.3));
    EXPECT_EQ(finest(squareScene(kSide * 4), camera, 4), 1);
}

TEST(LevelPlan, KeepsAllWhereItCannotTell)
{
    const Camera camera = orthographic(2.0);
    Scene odd = squareScene(kSide * 4);
    odd.images[0].width = odd.images[0].height = kSide * 4 - 1;
    EXPECT_EQ(finest(odd, camera), 0) << "level 1 is no half of level 0";
    Scene one = squareScene(kSide * 4);
    one.primitives[0].uvs[0].assign(4, vec2(0.5f));
    EXPECT_EQ(finest(one, camera), 0) << "magnified without end";
    Scene lines = squareScene(kSide * 4);
    lines.primitives[0].topology = Topology::lines;
    EXPECT_EQ(finest(lines, camera), 0);
    Scene noMips = squareScene(kSide * 4);
    noMips.textures[0].sampler.mip = MipFilter::none;
    EXPECT_EQ(finest(noMips, camera), 0);
}

TEST(LevelPlan, LooksAtEveryInstance)
{
    Scene scene = squareScene(kSide * 4);
    EXPECT_EQ(finest(scene, orthographic(2.0)), 1);
    scene.instances.push_back(Instance{});
    scene.instances[1].worldFromObject = dmat4(8.0); // eight times as large
    scene.instances[1].worldFromObject[3] = dvec4(0, 0, -1, 1);
    EXPECT_EQ(finest(scene, orthographic(2.0)), 0);
}

} // namespace
} // namespace torrance
