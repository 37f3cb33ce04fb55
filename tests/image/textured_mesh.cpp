// A mesh with every texture of glTF's core material, against rays cast on the CPU.
#include "mesh_truth.h"
#include "scene/camera_fit.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr double kTolerance = 2e-3; // of the foundation's statement of truth

TEST(TexturedMesh, AgreesWithRaysUnderEachPunctualLight)
{
    for (const Light::Kind kind : {Light::Kind::directional, Light::Kind::point, Light::Kind::spot}) {
        Scene scene = texturedTorus();
        scene.lights.push_back(testLight(kind));
        const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
        expectDrawnAsCast(scene, camera, settingsOf("gltf", 128), kTolerance,
                          "torus-" + std::to_string(static_cast<int>(kind)));
    }
}

TEST(TexturedMesh, AgreesWithRaysInAUniformEnvironment)
{
    Scene scene = texturedTorus();
    scene.environment = uniformEnvironment(dvec3(1.0, 0.9, 0.8));
    const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
    expectDrawnAsCast(scene, camera, settingsOf("gltf", 48), kTolerance, "torus-uniform");
}

TEST(TexturedMesh, MirroredAndSkewedNodesAreLitAlike)
{
    Scene scene = texturedTorus();
    dmat4 m(1.0);
    m[0] = dvec4(-1.2, 0.1, 0.0, 0.0); // mirrors, scales unevenly, shears
    m[1] = dvec4(0.3, 0.7, 0.0, 0.0);
    scene.instances[0].worldFromObject = m;
    scene.lights.push_back(testLight(Light::Kind::directional));
    const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
    expectDrawnAsCast(scene, camera, settingsOf("gltf", 96), kTolerance, "torus-mirrored");
}

TEST(TexturedMesh, TangentsThatTheFileDoesNotBring)
{
    Scene scene = texturedTorus();
    scene.primitives[0].tangents.clear();
    scene.lights.push_back(testLight(Light::Kind::directional));
    const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
    expectDrawnAsCast(scene, camera, settingsOf("gltf", 96), kTolerance, "torus-without-tangents");
}

TEST(TexturedMesh, AMillionMetresFromTheOrigin)
{
    Scene scene = texturedTorus();
    const dvec3 place(1e6, -2e6, 3e6);
    scene.instances[0].worldFromObject = translation(place);
    Light light = testLight(Light::Kind::point);
    light.position += place;
    scene.lights.push_back(light);
    const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
    expectDrawnAsCast(scene, camera, settingsOf("gltf", 96), kTolerance, "torus-far");
}

TEST(TexturedMesh, OrthographicCamera)
{
    Scene scene = texturedTorus();
    scene.lights.push_back(testLight(Light::Kind::directional));
    Camera camera = orbitCamera({0.4, 1.0}, 4.0, dvec3(0), 0.7);
    camera.kind = Camera::Kind::orthographic;
    camera.ymag = 1.6;
    camera.nearPlane = 0.1;
    camera.farPlane = 10.0;
    expectDrawnAsCast(scene, camera, settingsOf("gltf", 96), kTolerance, "torus-orthographic");
}

} // namespace
} // namespace torrance::test
