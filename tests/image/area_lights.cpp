// Lights with a radius, drawn on shapes, against their formulas in double.
#include "brdf/area_light.h"
#include "drawing.h"
#include "math/pixel_rotation.h"
#include "reference/analytic_shape.h"
#include "reference/pixel_condition.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "study/analytic_scenes.h"
#include "study/worst_pixel.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr int kSize = 24;
constexpr int kSamples = 32;

Picture drawLit(const Scene& scene, const Camera& camera, const char* method)
{
    Settings settings = settingsOf("gltf", kSize);
    settings.methods.areaLight = brdf::findMethod(brdf::Slot::areaLight, method);
    settings.lightSamples = kSamples;
    return draw(scene, camera, settings);
}

Scene sceneWith(const Light& light, double metallic = 0.5)
{
    Scene scene = shapeScene(AnalyticShape::Kind::sphere, plainMaterial(dvec3(0.9, 0.6, 0.3), metallic, 0.4));
    scene.lights.push_back(light);
    return scene;
}

Light bulb(double radius)
{
    Light light = testLight(Light::Kind::point);
    light.range = 0.0;
    light.radius = radius;
    return light;
}

/// What the pixel's formula is given; nothing where the ray misses.
std::optional<brdf::AreaQuery> queryOf(const Scene& scene, const PixelInputs& inputs, int x, int y)
{
    const Ray ray = {dvec3(0.0), glm::normalize(inputs.ray.direction)};
    const auto hit = intersectShape(inputs.shape, dvec3(0.0), ray, Sides::front);
    if (!hit)
        return std::nullopt;
    const Light& light = inputs.lights.front();
    brdf::AreaQuery query{.methods = *brdf::findPreset("gltf")};
    const Material& material = scene.materials[0];
    query.surface = brdf::makeShadingPoint(hit->normal, -ray.direction, hit->normal, material.roughnessFactor);
    query.surface.baseColor = dvec3(material.baseColorFactor);
    query.surface.metallic = material.metallicFactor;
    query.toCenter = light.position - hit->position;
    query.radius = light.radius;
    query.intensity = light.color * light.intensity;
    query.samples = kSamples;
    query.rotation = pixelRotation(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0);
    return query;
}

// Radii small, as large as the scene, and larger than the distance, so that the shape lies in the light.
TEST(AreaLights, EveryMethodIsItsFormula)
{
    for (const double radius : {0.05, 1.0, 4.0}) {
        const Scene scene = sceneWith(bulb(radius));
        const Camera camera = fitCamera(scene, {}, 1.0, 0.5, 0.02);
        for (const brdf::Method& method : brdf::allMethods()) {
            if (method.slot != brdf::Slot::areaLight)
                continue;
            const Picture picture = drawLit(scene, camera, std::string(method.id).c_str());
            WorstExcess worst;
            for (int y = 0; y < kSize; ++y)
                for (int x = 0; x < kSize; ++x) {
                    const PixelInputs inputs = pixelInputs(scene, 0, camera, kSize, kSize, x, y);
                    const auto query = queryOf(scene, inputs, x, y);
                    if (!query || glm::dot(query->surface.n, query->surface.v) < 0.05)
                        continue;
                    const dvec3 exact = std::get<brdf::AreaFormula>(method.formula)(*query);
                    // A sample at the horizon comes and goes with its rounding: NoL of 1e-6 of a light's whole.
                    const dvec3 rounding =
                        2.0 * pixelCondition(*brdf::findPreset("gltf"), inputs) + 1e-6 * glm::max(exact, dvec3(1.0));
                    worst.note(x, y, dvec3(pixelOf(picture, x, y)), exact, exact * 1e-4 + rounding);
                }
            EXPECT_LE(worst.excess, 1.0) << method.id << " radius " << radius << ": " << worst.text();
        }
    }
}

TEST(AreaLights, ARadiusOfNothingIsAPointByEveryMethod)
{
    const Scene point = sceneWith(bulb(0.0)), tiny = sceneWith(bulb(1e-8));
    const Camera camera = fitCamera(point, {}, 1.0, 0.5, 0.02);
    const Picture exact = drawLit(point, camera, "point");
    for (const char* method : {"representative", "sampled"}) {
        const Picture zero = drawLit(point, camera, method), near = drawLit(tiny, camera, method);
        EXPECT_EQ(zero.color.texels, exact.color.texels) << method;
        for (std::size_t i = 0; i < exact.color.texels.size(); ++i)
            EXPECT_NEAR(near.color.texels[i], exact.color.texels[i], 1e-6 + 3e-6 * exact.color.texels[i]) << method;
    }
}

} // namespace
} // namespace torrance::test
