// The white furnace: spheres of a white material in an environment of radiance 1 return what the model says, no more
// and no less.
#include "drawing.h"
#include "reference/pixel_condition.h"
#include "scene/camera_fit.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr double kTolerance = 2e-3; // of the foundation's statement of truth
constexpr double kLeastNoV = 0.05;
constexpr int kSize = 20;

constexpr double kRoughnesses[] = {0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1.0};

/// The camera's rays meet a sphere at n.v = 1 in the middle and 0 at the silhouette.
Scene furnaceScene(double metallic, double roughness)
{
    Scene scene;
    scene.materials.push_back(plainMaterial(dvec3(1.0), metallic, roughness));
    scene.shapes.push_back(
        {.kind = AnalyticShape::Kind::sphere, .material = 0, .worldFromObject = dmat4(1.0), .name = "ball"});
    scene.environment = uniformEnvironment(dvec3(1.0));
    return scene;
}

double cosineOfView(const PixelInputs& inputs)
{
    const dvec3 direction = glm::normalize(inputs.ray.direction);
    const dvec3 center(inputs.shape.worldFromObject[3]);
    const double apart2 = glm::dot(center, center) - glm::dot(center, direction) * glm::dot(center, direction);
    return apart2 < 1.0 ? std::sqrt(1.0 - apart2) : 0.0;
}

/// `exact` of a pixel's inputs; worst over a sweep of roughness.
void expectFurnace(double metallic, std::string_view preset, const std::function<double(const PixelInputs&)>& exact)
{
    for (const double roughness : kRoughnesses) {
        const Scene scene = furnaceScene(metallic, roughness);
        const Camera camera = fitCamera(scene, {}, 1.0, 0.5, 0.02);
        const Picture picture = draw(scene, camera, settingsOf(preset, kSize));
        Worst worst;
        int seen = 0;
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const PixelInputs inputs = pixelInputs(scene, 0, camera, kSize, kSize, x, y);
                if (cosineOfView(inputs) < kLeastNoV)
                    continue;
                ++seen;
                worst.note(x, y, dvec3(pixelOf(picture, x, y)), dvec3(exact(inputs)), dvec3(kTolerance));
            }
        EXPECT_GT(seen, 250);
        EXPECT_LE(worst.excess, 1.0) << preset << " metallic " << metallic << " r " << roughness << ": "
                                     << worst.text();
    }
}

double modelled(const PixelInputs& inputs)
{
    return pixelRadiance(*brdf::findPreset("gltf"), inputs).value().r;
}

TEST(Furnace, MetalReturnsWhatTheModelSays)
{
    expectFurnace(1.0, "gltf", modelled);
}

TEST(Furnace, HalfMetalReturnsWhatTheModelSays)
{
    expectFurnace(0.5, "gltf", modelled);
}

TEST(Furnace, DielectricReturnsWhatTheModelSays)
{
    expectFurnace(0.0, "gltf", modelled);
}

TEST(Furnace, CompensatedWhiteMetalReturnsAll)
{
    expectFurnace(1.0, "standard", [](const PixelInputs&) { return 1.0; });
}

} // namespace
} // namespace torrance::test
