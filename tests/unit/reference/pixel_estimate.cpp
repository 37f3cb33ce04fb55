#include "reference/pixel_estimate.h"

#include "../math/confidence.h"
#include "closed_forms.h"
#include "reference/pixel_condition.h"
#include "scene/camera_fit.h"

namespace torrance {
namespace {

using test::uniform;

/// A sphere of radius 1, half a metal, under a lamp and an even sky.
Scene ball()
{
    Scene scene;
    Material& material = scene.materials.emplace_back();
    material.baseColorFactor = dvec4(0.5, 0.25, 1.0, 1.0);
    material.metallicFactor = 0.5;
    material.roughnessFactor = 0.5;
    scene.shapes.push_back({AnalyticShape::Kind::sphere, 0, dmat4(1.0), "ball"});
    Light& lamp = scene.lights.emplace_back();
    lamp.kind = Light::Kind::point;
    lamp.position = dvec3(2.0, 3.0, 4.0);
    lamp.intensity = 20.0;
    scene.environment = uniform(dvec3(0.5, 1.0, 0.25));
    return scene;
}

ReferenceSettings settingsOf(int side, int directions)
{
    ReferenceSettings settings;
    settings.methods = *brdf::findPreset("standard");
    settings.width = settings.height = side;
    settings.directions = directions;
    settings.background = dvec4(0.0);
    return settings;
}

const Camera kCamera = orbitCamera({0.3, 1.2}, 4.0, dvec3(0.0), 0.6);

/// The sphere's pixels against the closed forms of lamp and furnace: how many 95 % intervals hold the truth.
struct Coverage
{
    int pixels = 0;
    int channelsInside = 0;
};

Coverage coverageOf(const ReferenceSettings& settings, double meanNorm)
{
    const Scene scene = ball();
    const PixelEstimator estimator(scene, kCamera, settings);
    Coverage coverage;
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x) {
            const PixelInputs inputs = pixelInputs(scene, 0, kCamera, settings.width, settings.height, x, y);
            const std::optional<dvec3> exact = pixelRadiance(settings.methods, inputs);
            const PixelEstimate pixel = estimator.estimate(x, y, meanNorm);
            EXPECT_EQ(pixel.color.a, exact ? 1.0 : 0.0);
            if (!exact)
                continue;
            ++coverage.pixels;
            for (int c = 0; c < 3; ++c)
                coverage.channelsInside +=
                    std::abs(pixel.color[c] - (*exact)[c]) <= kStudent95 * std::sqrt(pixel.variance[c]) + 1e-6;
        }
    return coverage;
}

TEST(PixelEstimate, IntervalsHoldTheTruthAsOftenAsTheySay)
{
    const Coverage coverage = coverageOf(settingsOf(32, 256), 0.0);
    ASSERT_GT(coverage.pixels, 400);
    // The channels of a pixel err together, so that only pixels count as independent: 0.95 minus four standard
    // deviations, for errors that are nearly, not quite, normal.
    const double share = coverage.channelsInside / (3.0 * coverage.pixels);
    EXPECT_GT(share, 0.95 - 4.0 * std::sqrt(0.05 * 0.95 / coverage.pixels));
}

TEST(PixelEstimate, StoppingAtATargetKeepsMostOfTheConfidence)
{
    // Who stops when an estimate of the spread is small enough stops too soon a little more often (Anscombe 1953).
    ReferenceSettings settings = settingsOf(32, 64);
    settings.targetError = 0.005;
    const Coverage coverage = coverageOf(settings, 1.0);
    EXPECT_GT(coverage.channelsInside / (3.0 * coverage.pixels), 0.88);
}

TEST(PixelEstimate, StopsDoublingWhereItIsTold)
{
    const Scene scene = ball();
    ReferenceSettings settings = settingsOf(9, 64);
    settings.targetError = 1e-9;
    settings.maxDirections = 300;
    EXPECT_EQ(PixelEstimator(scene, kCamera, settings).estimate(4, 4, 0.0).directions, 256.0);
    settings.targetError = 10.0;
    EXPECT_EQ(PixelEstimator(scene, kCamera, settings).estimate(4, 4, 0.0).directions, 64.0);
}

TEST(PixelEstimate, BlendedSurfacesLetTheBackgroundThroughAndMaskedOnesAreThereOrNot)
{
    Scene scene;
    scene.environment = uniform(dvec3(2.0));
    for (int i = 0; i < 2; ++i) { // two planes one behind the other, unlit, alpha 0.25 and 0.5
        Material& material = scene.materials.emplace_back();
        material.unlit = true;
        material.alphaMode = AlphaMode::blend;
        material.baseColorFactor = i == 0 ? dvec4(1.0, 0.0, 0.0, 0.25) : dvec4(0.0, 1.0, 0.0, 0.5);
        dmat4 place(1.0);
        place[3].z = -double(i);
        scene.shapes.push_back({AnalyticShape::Kind::plane, i, place, "pane"});
    }
    ReferenceSettings settings = settingsOf(1, 64);
    settings.background = std::nullopt;
    const Camera camera = orbitCamera({0.0, kPi / 2}, 4.0, dvec3(0.0), 0.2);
    const dvec4 through = PixelEstimator(scene, camera, settings).estimate(0, 0, 0.0).color;
    EXPECT_NEAR(glm::length(through - dvec4(0.25 + 0.75, 0.375 + 0.75, 0.75, 1.0)), 0.0, 1e-12); // 0.375 of 2 behind
    settings.background = dvec4(0.0);
    EXPECT_NEAR(PixelEstimator(scene, camera, settings).estimate(0, 0, 0.0).color.a, 0.625, 1e-12);
    scene.materials[0].alphaMode = AlphaMode::mask; // 0.25 is below the cutoff: not there
    EXPECT_NEAR(PixelEstimator(scene, camera, settings).estimate(0, 0, 0.0).color.r, 0.0, 1e-12);
    scene.materials[0].alphaCutoff = 0.2;
    EXPECT_NEAR(PixelEstimator(scene, camera, settings).estimate(0, 0, 0.0).color.r, 1.0, 1e-12);
}

TEST(PixelEstimate, PhysicsAgreesWithTheModelWhereBothAreExact)
{
    // A black body of index 1.5, seen and lit head on: no metal, no body, nothing but F = 0.04 and D V.
    Scene scene;
    Material& material = scene.materials.emplace_back();
    material.baseColorFactor = dvec4(0.0, 0.0, 0.0, 1.0);
    material.metallicFactor = 0.0;
    material.roughnessFactor = 0.3;
    scene.shapes.push_back({AnalyticShape::Kind::plane, 0, dmat4(1.0), "plane"});
    scene.lights.emplace_back();
    const Camera camera = orbitCamera({0.0, kPi / 2}, 4.0, dvec3(0.0), 0.2);
    ReferenceSettings settings = settingsOf(1, 4096);
    settings.methods = *brdf::findPreset("gltf");
    const PixelEstimate model = PixelEstimator(scene, camera, settings).estimate(0, 0, 0.0);
    settings.physics = true;
    const PixelEstimate physics = PixelEstimator(scene, camera, settings).estimate(0, 0, 0.0);
    EXPECT_EQ(model.variance, dvec3(0.0));
    // Light that is reflected twice adds F^2 (1 - E), below 0.04^2 of 1 / pi against 0.04 / (4 pi 0.09^2).
    EXPECT_NEAR(physics.color.r / model.color.r, 1.0, 2e-3);
    EXPECT_GE(physics.color.r, model.color.r);
}

// Of the four pixels of a quad a device takes one difference along each axis, between its first three.
TEST(PixelEstimate, PixelsOfAQuadShareTheChangeOfTextureCoordinates)
{
    Scene scene; // one triangle over the whole picture, tilted: what a pixel covers changes across it
    scene.materials.emplace_back();
    Primitive& triangle = scene.primitives.emplace_back();
    triangle.positions = {{-9.0f, -9.0f, -6.0f}, {9.0f, -9.0f, 3.0f}, {0.0f, 12.0f, 0.0f}};
    triangle.uvs[0] = {{0.0f, 0.0f}, {1.0f, 0.1f}, {0.3f, 1.0f}};
    triangle.indices = {0, 1, 2};
    triangle.material = 0;
    scene.instances.emplace_back();
    ReferenceSettings settings = settingsOf(8, 64);
    settings.levelBias = 0.0;
    const PixelEstimator estimator(scene, orbitCamera({0.0, kPi / 2}, 6.0, dvec3(0.0), 0.6), settings);
    const auto seen = [&](int x, int y, const dvec2& place) {
        const VisibleSurfaces surfaces = estimator.surfacesAt(dvec2(x, y) + place, {x, y});
        EXPECT_EQ(surfaces.surfaces.size(), 1u);
        return surfaces.surfaces.at(0).surface;
    };
    for (const dvec2& place : {dvec2(0.5), dvec2(0.9, -0.3)}) { // the second lies in another pixel of the quad
        const dvec2 first = seen(2, 4, place).uvs[0];
        const dvec2 right = seen(3, 4, place).uvs[0] - first, below = seen(2, 5, place).uvs[0] - first;
        for (const ivec2& pixel : {ivec2(2, 4), ivec2(3, 4), ivec2(2, 5), ivec2(3, 5)}) {
            const UvSteps steps = seen(pixel.x, pixel.y, place).footprint->uvs[0];
            EXPECT_LT(glm::length(steps.right - right), 1e-12) << pixel.x << ", " << pixel.y;
            EXPECT_LT(glm::length(steps.below - below), 1e-12) << pixel.x << ", " << pixel.y;
        }
        EXPECT_GT(glm::length(seen(4, 4, place).footprint->uvs[0].right - right), 1e-4) << "the next quad's is its own";
    }
}

} // namespace
} // namespace torrance
