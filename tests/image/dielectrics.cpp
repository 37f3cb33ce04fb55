// Dielectrics of other indices than glTF's 1.5, against rays.
#include "mesh_truth.h"
#include "scene/camera_fit.h"
#include "scene/named_material.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr double kTolerance = 2e-3; // as for the textured mesh

Scene torusOf(const char* name)
{
    Scene scene = texturedTorus();
    Material& material = scene.materials[0];
    material.ior = materialOf(*findNamedMaterial(name)).ior;
    material.metallicFactor = 0.3; // so that the dielectric's part and the metal's are both there
    return scene;
}

TEST(Dielectrics, ReflectByTheirIndexUnderALight)
{
    for (const char* name : {"water", "diamond"}) {
        Scene scene = torusOf(name);
        scene.lights.push_back(testLight(Light::Kind::point));
        const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
        expectDrawnAsCast(scene, camera, settingsOf("standard", 96), kTolerance, std::string("torus-") + name);
    }
}

TEST(Dielectrics, ReflectByTheirIndexInAUniformEnvironment)
{
    for (const char* name : {"water", "diamond"}) {
        Scene scene = torusOf(name);
        scene.environment = uniformEnvironment(dvec3(1.0, 0.9, 0.8));
        const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
        expectDrawnAsCast(scene, camera, settingsOf("gltf", 48), kTolerance, std::string("uniform-") + name);
    }
}

} // namespace
} // namespace torrance::test
