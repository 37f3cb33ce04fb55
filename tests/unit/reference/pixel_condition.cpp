#include "reference/pixel_condition.h"

#include "scene/camera_fit.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

Scene sphereScene()
{
    Scene scene;
    scene.shapes.push_back(AnalyticShape{});
    scene.shapes.back().material = 0;
    scene.materials.emplace_back();
    scene.materials[0].metallicFactor = 0.0;
    scene.lights.emplace_back();
    scene.lights[0].direction = glm::normalize(dvec3(-1, -1, -2));
    return scene;
}

TEST(PixelCondition, OfADiffuseGreySphereIsAFewRoundings)
{
    // In the middle of a matte sphere nothing is steep: a dozen inputs, each with a condition of order one.
    const Scene scene = sphereScene();
    const Camera camera = orbitCamera({}, 4.0, dvec3(0), 0.8);
    const brdf::Preset& methods = *brdf::findPreset("gltf");
    const PixelInputs inputs = pixelInputs(scene, 0, camera, 65, 65, 32, 32);
    const dvec3 radiance = pixelRadiance(methods, inputs).value();
    const dvec3 condition = pixelCondition(methods, inputs);
    EXPECT_GT(condition.r, 0.1 * kInputRounding * radiance.r);
    EXPECT_LT(condition.r, 100.0 * kInputRounding * radiance.r);
}

TEST(PixelCondition, GrowsTowardsTheSilhouetteAndEndsThereInInfinity)
{
    const Scene scene = sphereScene();
    const Camera camera = orbitCamera({}, 4.0, dvec3(0), 0.8);
    const brdf::Preset& methods = *brdf::findPreset("gltf");
    PixelInputs inputs = pixelInputs(scene, 0, camera, 65, 65, 32, 32);
    const double edge = 0.25; // sine of the angle at which a ray 4 from the centre touches the sphere of radius 1
    const auto at = [&](double sine) {
        inputs.ray.direction = dvec3(sine, 0.0, -std::sqrt(1.0 - sine * sine));
        const double value = pixelRadiance(methods, inputs).value().r;
        return pixelCondition(methods, inputs).r / value;
    };
    EXPECT_GT(at(edge * (1.0 - 1e-4)), 10.0 * at(0.5 * edge));
    EXPECT_TRUE(std::isinf(at(edge * (1.0 - 1e-9))));
}

TEST(PixelCondition, RadianceIsNothingBesideTheShape)
{
    const Scene scene = sphereScene();
    const Camera camera = orbitCamera({}, 4.0, dvec3(0), 0.8);
    EXPECT_FALSE(pixelRadiance(*brdf::findPreset("gltf"), pixelInputs(scene, 0, camera, 65, 65, 0, 0)));
}

} // namespace
} // namespace torrance
