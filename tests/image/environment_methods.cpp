// Every method of the slots environment_diffuse and environment_specular, drawn on spheres, against its formula in
// double.
#include "brdf/albedo.h"
#include "brdf/environment.h"
#include "core/error.h"
#include "drawing.h"
#include "math/frame.h"
#include "math/low_discrepancy.h"
#include "math/pixel_rotation.h"
#include "math/sampling.h"
#include "plan/light_plan.h"
#include "prepare/environment_maps.h"
#include "reference/analytic_shape.h"
#include "reference/environment_sampler.h"
#include "reference/pixel_condition.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "study/worst_pixel.h"
#include "tests/panorama_of.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

using brdf::Method;
using brdf::Slot;

constexpr int kSize = 16;
constexpr int kPanoramaWidth = 256;
constexpr double kLeastNoV = 0.1;
const dvec3 kToSun = glm::normalize(dvec3(0.5, 0.7, 0.4));
constexpr double kSunOneLessCosine = 0.012; // exp(-12) is left of the sun

std::vector<const Method*> rowsOf(Slot slot)
{
    std::vector<const Method*> rows;
    for (const Method& method : brdf::allMethods())
        if (method.slot == slot && method.ownModel.empty()) // those of sources are judged by themselves
            rows.push_back(&method);
    return rows;
}

Scene ball(const Material& material, Environment environment)
{
    Scene scene;
    scene.environment = std::move(environment);
    scene.materials.push_back(material);
    scene.shapes.push_back(
        {.kind = AnalyticShape::Kind::sphere, .material = 0, .worldFromObject = dmat4(1.0), .name = "ball"});
    return scene;
}

Camera cameraOf(const Scene& scene)
{
    return fitCamera(scene, {}, 1.0, 0.5, 0.02);
}

// The sun behind the ball, and above it.
Camera backLit(const Scene& scene)
{
    return fitCamera(scene, {.theta = std::atan2(kToSun.x, kToSun.z) + kPi}, 1.0, 0.5, 0.02);
}

Picture drawWith(const Scene& scene, Slot slot, const Method& method, int samples = 64)
{
    Settings settings = settingsOf("gltf", kSize);
    settings.methods[slot] = &method;
    settings.environmentSamples = samples;
    return draw(scene, cameraOf(scene), settings);
}

/// Calls f(x, y, query) where the sphere is seen at n.v of kLeastNoV or more; the query has the pixel's n and v.
template <typename Function>
void forEachPixel(const Scene& scene, const Camera& camera, const Function& f)
{
    int seen = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const PixelInputs inputs = pixelInputs(scene, 0, camera, kSize, kSize, x, y);
            const Ray ray = {dvec3(0.0), glm::normalize(inputs.ray.direction)};
            const auto hit = intersectShape(inputs.shape, dvec3(0.0), ray, Sides::front);
            if (!hit || -glm::dot(hit->normal, ray.direction) < kLeastNoV)
                continue;
            ++seen;
            brdf::EnvironmentQuery query;
            query.n = hit->normal;
            query.v = -ray.direction;
            query.perceptualRoughness = static_cast<double>(static_cast<float>(scene.materials[0].roughnessFactor));
            query.rotation = pixelRotation(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0);
            query.f0 = dvec3(scene.materials[0].baseColorFactor);
            f(x, y, query);
        }
    EXPECT_GT(seen, kSize * kSize / 2);
}

template <typename Function>
void forEachPixel(const Scene& scene, const Function& f)
{
    forEachPixel(scene, cameraOf(scene), f);
}

void expectAllowed(const WorstExcess& worst, const std::string& what)
{
    EXPECT_LE(worst.excess, 1.0) << what << ": " << worst.text();
}

// What white adds to black is the diffuse light: irradiance / pi times (1 - F0)(1 - w).
TEST(EnvironmentDiffuse, EveryMethodIsItsFormula)
{
    const Scene white = ball(plainMaterial(dvec3(1.0), 0.0, 0.5), panoramaOf(glow, kPanoramaWidth));
    const Scene black = ball(plainMaterial(dvec3(0.0), 0.0, 0.5), panoramaOf(glow, kPanoramaWidth));
    for (const Method* method : rowsOf(Slot::environmentDiffuse)) {
        const Picture lit = drawWith(white, Slot::environmentDiffuse, *method);
        const Picture unlit = drawWith(black, Slot::environmentDiffuse, *method);
        WorstExcess worst;
        forEachPixel(white, [&](int x, int y, brdf::EnvironmentQuery query) {
            query.radiance = glow;
            const dvec3 irradiance = std::get<brdf::EnvironmentFormula>(method->formula)(query);
            const double passed = 0.96 * (1.0 - brdf::schlickDiffuseWeight(std::min(1.0, glm::dot(query.n, query.v))));
            // 1e-3 is what the irradiance cube's nodes are off by (prepare/irradiance.h); between them, 1/16 apart, a
            // bilinear look-up misses up to 2 h^2 / 8 of a curvature of about 2.
            worst.note(x, y, dvec3(pixelOf(lit, x, y) - pixelOf(unlit, x, y)), irradiance * passed,
                       irradiance * passed * 3e-3);
        });
        expectAllowed(worst, std::string(method->id));
    }
}

TEST(EnvironmentDiffuse, AnEvenEnvironmentIsExactByEveryMethod)
{
    const dvec3 radiance(0.5, 1.0, 2.0);
    const Scene scene = ball(plainMaterial(dvec3(0.8, 0.6, 0.4), 0.0, 0.5), uniformEnvironment(radiance));
    for (const Method* method : rowsOf(Slot::environmentDiffuse)) {
        const Picture picture = drawWith(scene, Slot::environmentDiffuse, *method);
        WorstExcess worst;
        forEachPixel(scene, [&](int x, int y, const brdf::EnvironmentQuery&) {
            const PixelInputs inputs = pixelInputs(scene, 0, cameraOf(scene), kSize, kSize, x, y);
            const dvec3 exact = pixelRadiance(*brdf::findPreset("gltf"), inputs).value();
            worst.note(x, y, dvec3(pixelOf(picture, x, y)), exact, exact * 2e-4); // twice the table's interpolation
        });
        expectAllowed(worst, std::string(method->id));
    }
}

// Of a small bright sun nine harmonics go far below zero, where the light is cut off; the window leaves some
// everywhere.
TEST(EnvironmentDiffuse, TheWindowCutsNothingOff)
{
    const auto sun = [](const dvec3& d) {
        return dvec3(100.0 * std::exp(30.0 * (glm::dot(d, glm::normalize(dvec3(-0.9, 0.3, -0.4))) - 1.0)));
    };
    const Scene white = ball(plainMaterial(dvec3(1.0), 0.0, 1.0), panoramaOf(sun, kPanoramaWidth));
    const Scene black = ball(plainMaterial(dvec3(0.0), 0.0, 1.0), panoramaOf(sun, kPanoramaWidth));
    const auto cutOff = [&](const char* id) {
        const Method& method = *brdf::findMethod(Slot::environmentDiffuse, id);
        const Picture lit = drawWith(white, Slot::environmentDiffuse, method);
        const Picture unlit = drawWith(black, Slot::environmentDiffuse, method);
        int count = 0;
        forEachPixel(white, [&](int x, int y, const brdf::EnvironmentQuery&) {
            count += pixelOf(lit, x, y) == pixelOf(unlit, x, y);
        });
        return count;
    };
    EXPECT_GT(cutOff("sh9"), 5);
    EXPECT_EQ(cutOff("sh9_windowed"), 0);
}

// Radiance 1 in all directions leaves the samplers, weights and points themselves: device and double draw the same
// directions.
TEST(EnvironmentSpecular, SamplersAreTheirFormulasPointByPoint)
{
    for (const double roughness : {0.1, 0.4, 1.0}) {
        const Scene scene = ball(plainMaterial(dvec3(1.0, 0.5, 0.1), 1.0, roughness), uniformEnvironment(dvec3(1.0)));
        for (const Method* method : rowsOf(Slot::environmentSpecular)) {
            if (!brdf::drawsSamples(*method))
                continue;
            const Picture picture = drawWith(scene, Slot::environmentSpecular, *method, 32);
            WorstExcess worst;
            forEachPixel(scene, [&](int x, int y, brdf::EnvironmentQuery query) {
                query.radiance = [](const dvec3&) { return dvec3(1.0); };
                query.samples = 32;
                const dvec3 exact = std::get<brdf::EnvironmentFormula>(method->formula)(query);
                worst.note(x, y, dvec3(pixelOf(picture, x, y)), exact, exact * 1e-4);
            });
            expectAllowed(worst, std::string(method->id) + " r " + std::to_string(roughness));
        }
    }
}

// Split sums: at the roughnesses that are levels of the chain, which are within 1 % (prepare/cube_tree.h); between the
// texels of the last, 1/4 apart, a bilinear look-up misses up to 2 h^2 / 8 of the curvature, 1/2 there. Samples: the
// same directions on both sides, of which the device alone blurs: 2/3 h^2 of the radiance's curvature, 4 or less, where
// a sample stands for a square of half side h = sqrt(1 / (N density)) / 2 <= 0.05. At grazing, normals drawn from D
// alone meet lower densities with larger weights: that blur is the method's own, and it is judged where n.v > 1/2.
TEST(EnvironmentSpecular, EveryMethodIsItsFormulaUnderARealEnvironment)
{
    constexpr int kLevels = 4; // of the chain that kPanoramaWidth gives
    for (const int level : {1, 2, 3}) {
        const Scene scene = ball(plainMaterial(dvec3(1.0), 1.0, std::sqrt(levelAlpha(level, kLevels))),
                                 panoramaOf(glow, kPanoramaWidth));
        for (const Method* method : rowsOf(Slot::environmentSpecular)) {
            constexpr int kSamples = 1024;
            const Picture picture = drawWith(scene, Slot::environmentSpecular, *method, kSamples);
            WorstExcess worst;
            forEachPixel(scene, [&](int x, int y, brdf::EnvironmentQuery query) {
                const bool grazing = glm::dot(query.n, query.v) < 0.5;
                if ((x + y) % 3 != 0 || (grazing && method->id == "filtered_importance"))
                    return; // the rest is as long to compute and no different
                query.radiance = glow;
                query.samples = kSamples;
                const dvec3 exact = std::get<brdf::EnvironmentFormula>(method->formula)(query);
                worst.note(x, y, dvec3(pixelOf(picture, x, y)), exact,
                           exact * (brdf::drawsSamples(*method) ? 1e-2 : 1.8e-2));
            });
            expectAllowed(worst, std::string(method->id) + " at level " + std::to_string(level));
        }
    }
}

double relativeError(const Picture& picture, const Scene& scene, const brdf::EnvironmentFormula& exactly)
{
    double error = 0.0, light = 0.0;
    forEachPixel(scene, [&](int x, int y, brdf::EnvironmentQuery query) {
        if ((x + y) % 3 != 0)
            return;
        query.radiance = glow;
        query.samples = 1 << 12;
        const dvec3 exact = exactly(query);
        error += glm::length(dvec3(pixelOf(picture, x, y)) - exact);
        light += glm::length(exact);
    });
    return error / light;
}

// What METHODS say of the three kinds, on a rough sphere: the mirror direction is off by many per cent, the dominant
// one by fewer, and samples converge to the integral.
TEST(EnvironmentSpecular, TheDominantDirectionIsNearerAndSamplesConverge)
{
    const Scene scene = ball(plainMaterial(dvec3(1.0), 1.0, 0.7), panoramaOf(glow, kPanoramaWidth));
    const auto errorOf = [&](const char* id, int samples) {
        return relativeError(
            drawWith(scene, Slot::environmentSpecular, *brdf::findMethod(Slot::environmentSpecular, id), samples),
            scene, &brdf::Es_vndf_bounded);
    };
    const double splitSum = errorOf("split_sum", 1), dominant = errorOf("split_sum_dominant", 1);
    EXPECT_LT(dominant, splitSum);
    for (const char* id : {"filtered_importance", "vndf", "vndf_caps", "vndf_bounded"}) {
        const double few = errorOf(id, 8), many = errorOf(id, 512);
        EXPECT_LT(many, 0.25 * few) << id;
        EXPECT_LT(many, 0.25 * dominant) << id;
    }
}

// A sun of a few degrees.
dvec3 sunOf(const dvec3& d)
{
    return dvec3(300.0, 250.0, 200.0) * std::exp(1000.0 * (glm::dot(d, kToSun) - 1.0));
}

dvec3 sunny(const dvec3& d)
{
    return dvec3(0.3, 0.5, 0.8) + sunOf(d);
}

// 64 directions come far nearer to the integral with points than without, whatever the lobe. The
// truth is points that lie so densely over the sun that directions leave it to them.
TEST(EnvironmentSpecular, PointsFindTheLampsThatDirectionsMiss)
{
    constexpr std::uint32_t kPoints = 4096;
    std::vector<brdf::LampPoint> points;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
        const dvec3 d = frameAround(kToSun) * sampleCone(kSunOneLessCosine, hammersley(i, kPoints));
        points.push_back({d, sunOf(d) * (2.0 * kPi * kSunOneLessCosine / kPoints), 1e9});
    }
    const auto exactly = [&](brdf::EnvironmentQuery query) {
        query.radiance = sunny;
        query.lampPoints = points;
        query.lamps = [](const dvec3& d) { return brdf::LampLight{sunOf(d), 1e9}; };
        return brdf::Es_vndf_lamps(query);
    };
    for (const double roughness : {0.3, 0.5, 0.8}) {
        const Scene scene = ball(plainMaterial(dvec3(1.0), 1.0, roughness), panoramaOf(sunny, kPanoramaWidth));
        const auto errorOf = [&](const char* id, int samples) {
            const Picture picture =
                drawWith(scene, Slot::environmentSpecular, *brdf::findMethod(Slot::environmentSpecular, id), samples);
            double error = 0.0, light = 0.0;
            forEachPixel(scene, [&](int x, int y, brdf::EnvironmentQuery query) {
                query.samples = 256;
                const dvec3 exact = exactly(query);
                error += glm::length(dvec3(pixelOf(picture, x, y)) - exact);
                light += glm::length(exact);
            });
            return error / light;
        };
        const double lamps = errorOf("vndf_lamps", 64), directions = errorOf("vndf_bounded", 64);
        EXPECT_LT(lamps, 0.5 * directions) << roughness;
        EXPECT_LT(lamps, 0.5 * errorOf("vndf_lamps", 4)) << roughness;
        EXPECT_LT(lamps, 1e-2) << roughness; // twice what the cube's energy may be off (environment_maps.h)
    }
}

// The interface lets less through of what comes in flat. A sun's light does so as a whole or not at all, which no mean
// over directions knows, but the points that stand for it do.
TEST(EnvironmentDiffuse, TheInterfaceDimsLampsByWhereTheyAre)
{
    const Method& lamps = *brdf::findMethod(Slot::environmentSpecular, "vndf_lamps");
    const Scene white = ball(plainMaterial(dvec3(1.0), 0.0, 0.5), panoramaOf(sunny, kPanoramaWidth));
    const Scene black = ball(plainMaterial(dvec3(0.0), 0.0, 0.5), panoramaOf(sunny, kPanoramaWidth));
    const dvec3 sky = sunny(-kToSun); // of one radiance
    for (const std::string_view weight : {"fresnel_voh", "fresnel_nol_nov"}) {
        const auto drawn = [&](const Scene& scene) {
            Settings settings = settingsOf("gltf", kSize);
            settings.methods[Slot::environmentSpecular] = &lamps;
            settings.methods[Slot::diffuseWeight] = brdf::findMethod(Slot::diffuseWeight, weight);
            return draw(scene, backLit(scene), settings);
        };
        const Picture lit = drawn(white), unlit = drawn(black);
        double error = 0.0, light = 0.0;
        forEachPixel(white, backLit(white), [&](int x, int y, const brdf::EnvironmentQuery& query) {
            const double NoV = std::min(1.0, glm::dot(query.n, query.v));
            const auto passed = [&](double atVoH, double atNoL) {
                return weight == "fresnel_voh" ? 0.96 * (1.0 - atVoH)
                                               : 0.96 * (1.0 - atNoL) * 0.96 * (1.0 - std::pow(1.0 - NoV, 5));
            };
            dvec3 exact = sky * passed(brdf::schlickDiffuseWeight(NoV), 1.0 / 21.0);
            constexpr std::uint32_t kPoints = 1024;
            for (std::uint32_t i = 0; i < kPoints; ++i) {
                const dvec3 l = frameAround(kToSun) * sampleCone(kSunOneLessCosine, hammersley(i, kPoints));
                const double NoL = glm::dot(query.n, l), VoH = glm::length(query.v + l) / 2.0;
                if (NoL > 0.0)
                    exact += sunOf(l) * (2.0 * kSunOneLessCosine / kPoints * NoL *
                                         passed(std::pow(1.0 - VoH, 5), std::pow(1.0 - NoL, 5)));
            }
            error += glm::length(dvec3(pixelOf(lit, x, y) - pixelOf(unlit, x, y)) - exact);
            light += glm::length(exact);
        });
        EXPECT_LT(error, 1e-3 * light) << weight; // what the irradiance cube's nodes are off by (prepare/irradiance.h)
    }
}

// A small lamp in a wide one: points lie a thousand times as densely on it, and one footprint of a direction holds
// both. What directions leave to points, points must find: the light of all pixels together is that of the integral. Of
// densities that are averaged with the light it was not, for weights are convex in them.
TEST(EnvironmentSpecular, DirectionsAndPointsTogetherLoseNoLight)
{
    const auto glow = [](const dvec3& d) {
        const double oneLessCosine = 1.0 - glm::dot(d, kToSun);
        return dvec3(0.3) + dvec3(30.0) * std::exp(-oneLessCosine / 0.1) +
               dvec3(6000.0) * std::exp(-oneLessCosine / 0.001);
    };
    for (const double roughness : {0.4, 0.7, 1.0}) {
        const Scene scene = ball(plainMaterial(dvec3(1.0), 1.0, roughness), panoramaOf(glow, kPanoramaWidth));
        const Picture picture =
            drawWith(scene, Slot::environmentSpecular, *brdf::findMethod(Slot::environmentSpecular, "vndf_lamps"), 64);
        double drawn = 0.0, exact = 0.0;
        forEachPixel(scene, [&](int x, int y, brdf::EnvironmentQuery query) {
            if ((x + 3 * y) % 7 != 0)
                return;
            query.radiance = glow;
            query.samples = 1 << 14;
            drawn += glm::dot(dvec3(pixelOf(picture, x, y)), dvec3(1.0));
            exact += glm::dot(brdf::Es_vndf_bounded(query), dvec3(1.0));
        });
        EXPECT_NEAR(drawn / exact, 1.0, 5e-3) << roughness; // what the cube's energy may be off (environment_maps.h)
    }
}

// A mirror shows the texels of what its directions are drawn from: of many directions, texels half as large.
TEST(EnvironmentSpecular, ManyDirectionsShowMirrorsMoreExactly)
{
    const auto stripes = [](const dvec3& d) { return dvec3(std::sin(20.0 * std::atan2(d.z, d.x)) > 0.0 ? 1.0 : 0.1); };
    const Scene scene = ball(plainMaterial(dvec3(1.0), 1.0, 0.0), panoramaOf(stripes, kPanoramaWidth));
    const EnvironmentSampler panorama(*scene.environment);
    const auto errorOf = [&](int samples) {
        const Picture picture = drawWith(scene, Slot::environmentSpecular,
                                         *brdf::findMethod(Slot::environmentSpecular, "vndf_lamps"), samples);
        double error = 0.0;
        forEachPixel(scene, [&](int x, int y, const brdf::EnvironmentQuery& query) {
            const dvec3 exact = panorama.at(glm::reflect(-query.v, query.n)).radiance;
            error += glm::length(dvec3(pixelOf(picture, x, y)) - exact);
        });
        return error;
    };
    EXPECT_LT(errorOf(kManyDirections), 0.7 * errorOf(kManyDirections - 1)); // half but for edges that few pixels see
}

TEST(EnvironmentSpecular, LampsNeedTheirPlaceBehindTheLights)
{
    Scene scene = ball(plainMaterial(dvec3(1.0), 1.0, 0.5), panoramaOf(sunny, kPanoramaWidth));
    Settings settings = settingsOf("gltf", kSize);
    settings.methods[Slot::environmentSpecular] = brdf::findMethod(Slot::environmentSpecular, "vndf_lamps");
    settings.environmentSamples = 16;
    for (std::size_t i = 0; i <= kMostLights - 64; ++i)
        scene.lights.push_back(Light{});
    EXPECT_THROW(makePlan(scene, settings), Error);
    scene.lights.pop_back();
    EXPECT_NO_THROW(makePlan(scene, settings));
    settings.methods[Slot::environmentDiffuse] = brdf::findMethod(Slot::environmentDiffuse, "sampled");
    EXPECT_THROW(makePlan(scene, settings), Error);
}

} // namespace
} // namespace torrance::test
