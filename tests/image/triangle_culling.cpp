// Triangles that show at no pixel's centre are left out on the processor: no byte of the picture knows of it.
#include "drawing.h"
#include "gpu/test_device.h"
#include "plan/path_plan.h"
#include "scene/camera_fit.h"
#include "scene/primitive_bounds.h"
#include "scene/shape_mesh.h"
#include "scenes.h"
#include "two_paths.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

void expectSamePicture(const Scene& scene, const Camera& camera, Settings settings, const std::string& name)
{
    settings.triangleCulling = true;
    const Picture culled = draw(scene, camera, settings);
    settings.triangleCulling = false;
    const Picture whole = draw(scene, camera, settings);
    EXPECT_TRUE(culled.color.texels == whole.color.texels) << name;
    ASSERT_EQ(culled.layers.size(), whole.layers.size());
    for (std::size_t i = 0; i < whole.layers.size(); ++i)
        EXPECT_TRUE(culled.layers[i].image.texels == whole.layers[i].image.texels)
            << name << ", " << whole.layers[i].name;
    int covered = 0;
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x)
            covered += pixelOf(whole, x, y).a > 0.0;
    EXPECT_GT(covered, settings.width * settings.height / 10) << name << ": hardly anything is seen";
}

/// Tori: two of one draw, one mirrored, and one whose vertices lie far from their origin.
Scene tori()
{
    Scene scene = texturedTorus();
    dmat4 mirrored = translation(dvec3(0.0, 1.2, 0.0));
    mirrored[0] *= -0.7;
    for (const dmat4& placed : {translation(dvec3(0.5, -0.9, 0.4)), mirrored}) {
        scene.instances.push_back(scene.instances[0]);
        scene.instances.back().worldFromObject = placed;
    }
    constexpr dvec3 kFar(0.0, 300.0, 0.0);
    Primitive far = scene.primitives[0];
    for (vec3& p : far.positions)
        p = vec3(0.5 * dvec3(p) + kFar);
    setBounds(far);
    addInstance(scene, std::move(far), translation(dvec3(-1.2, 0.3, 0.0) - kFar));
    scene.lights = {testLight(Light::Kind::directional), testLight(Light::Kind::point)};
    scene.environment = uniformEnvironment(dvec3(1.0, 0.9, 0.8));
    return scene;
}

TEST(TriangleCulling, DrawsTheSamePicture)
{
    Scene scene = tori();
    for (const bool doubleSided : {false, true}) {
        for (Material& material : scene.materials)
            material.doubleSided = doubleSided;
        for (const RenderPath path : kRenderPaths)
            for (const double distance : {4.0, 1.2}) { // and from within the hole, behind the eye as before it
                Settings settings = settingsOf("standard", 48);
                settings.path = path;
                const Camera camera = orbitCamera({0.4, 1.0}, distance, dvec3(0.0), 0.9);
                expectSamePicture(scene, camera, settings,
                                  nameOf(path) + std::string(doubleSided ? ", both sides, " : ", ") +
                                      std::to_string(distance));
            }
    }
}

// Whose backs are left out where it is seen from outside.
TEST(TriangleCulling, DrawsTheSameInsideOfABody)
{
    Scene scene;
    scene.materials.emplace_back().doubleSided = true;
    Primitive sphere = sphereMesh();
    sphere.material = 0;
    addInstance(scene, std::move(sphere), dmat4(1.0));
    scene.environment = uniformEnvironment(dvec3(1.0));
    for (const double distance : {0.5, 3.0})
        expectSamePicture(scene, orbitCamera({0.4, 1.0}, distance, dvec3(0.0), 0.9), settingsOf("gltf", 40),
                          std::to_string(distance));
}

TEST(TriangleCulling, DrawsTheSameSurfacesOfAllKinds)
{
    const Scene scene = sceneOfAllSurfaces();
    for (const RenderPath path : kRenderPaths) {
        Settings settings = settingsOf("standard", 64);
        settings.path = path;
        settings.layers = true;
        expectSamePicture(scene, orthographicCamera(), settings, nameOf(path));
    }
}

TEST(TriangleCulling, DrawsTheSameSamples)
{
    const Scene scene = tori();
    const Camera camera = orbitCamera({0.4, 1.0}, 4.0, dvec3(0.0), 0.9);
    Settings settings = settingsOf("standard", 48);
    settings.samples = 4;
    for (const RenderPath path : {RenderPath::prepass, RenderPath::attributes}) {
        settings.path = path;
        for (const char* method : {"supersampled", "reconstructed"}) {
            settings.methods.pixelSampling = brdf::findMethod(brdf::Slot::pixelSampling, method);
            expectSamePicture(scene, camera, settings, method);
        }
    }
}

// One renderer, many frames: what it keeps is of the last.
TEST(TriangleCulling, FollowsTheCamera)
{
    const Scene scene = tori();
    Settings settings = settingsOf("gltf", 40);
    settings.triangleCulling = true;
    const ShadingPlan plan = makePlan(scene, settings);
    Renderer renderer(device(), shaders(), {});
    const DeviceScene onDevice = renderer.upload(scene, plan);
    for (const double distance : {40.0, 3.0, 1.2, 40.0}) {
        const Camera camera = orbitCamera({0.4 + distance, 1.0}, distance, dvec3(0.0), 0.9);
        settings.triangleCulling = false;
        EXPECT_TRUE(renderer.render(onDevice, camera).color.texels == draw(scene, camera, settings).color.texels)
            << distance;
    }
    Renderer fresh(device(), shaders(), {});
    const DeviceScene unseen = fresh.upload(scene, plan);
    Camera away = orbitCamera({0.4, 1.0}, 3.0, dvec3(0.0), 0.9);
    away.worldFromCamera[0] *= -1.0; // half a turn about its own up
    away.worldFromCamera[2] *= -1.0;
    const Image nothing = fresh.render(unseen, away).color;
    EXPECT_TRUE(std::ranges::all_of(nothing.texels, [](float value) { return value == 0.0f; }));
}

} // namespace
} // namespace torrance::test
