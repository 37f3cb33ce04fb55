// The search for a picture within a tolerance, with pictures that no device drew.
#include "study/tolerance_search.h"

#include "scene/camera_fit.h"
#include "tests/panorama_of.h"
#include "tests/shipped_table.h"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace torrance {
namespace {

constexpr int kSize = 16;

/// A metal sphere under a bright sky.
struct Asked
{
    Scene scene;
    Settings settings{.methods = *brdf::findPreset("standard")};
    MethodTable table = test::shippedTable();
    Image black{kSize, kSize, 4};

    Asked()
    {
        Material& metal = scene.materials.emplace_back();
        metal.baseColorFactor = dvec4(0.8);
        metal.roughnessFactor = 0.3;
        scene.shapes.push_back({AnalyticShape::Kind::sphere, 0, dmat4(1.0), "sphere"});
        scene.environment = test::panoramaOf([](const dvec3& d) { return dvec3(0.6 + 0.4 * d.y); }, 32);
        settings.width = settings.height = kSize;
    }

    ToleranceResult search(double tolerance, const DrawPicture& draw, int pixels = kDefaultCertified) const
    {
        const Camera camera = fitCamera(scene, {0.3, 1.2}, 1.0, 0.7, 0.05);
        return drawWithin({.scene = scene,
                           .camera = camera,
                           .asked = settings,
                           .table = table,
                           .tolerance = {.mean = tolerance, .percentile99 = {}},
                           .request = {.pixels = pixels}},
                          draw);
    }
};

// Whatever is drawn is black: off by all of its light, little more than allowed, so that methods go up slowly. What is
// tried last is the nearest there is all the same: the exact plan would not be within either.
TEST(ToleranceSearch, EndsWithTheNearestMethods)
{
    const Asked asked;
    const ToleranceResult result =
        asked.search(0.95, [&](const Settings&, std::span<const PixelBox>) -> const Image& { return asked.black; });
    EXPECT_FALSE(result.holds);
    EXPECT_TRUE(isNearest(result.plan));
    EXPECT_EQ(result.trials.size(), static_cast<std::size_t>(kMostSteps) + 1);
    EXPECT_NE(result.obstacle.find("nearest methods"), std::string::npos) << result.obstacle;
}

// Black is off by all of its light, and may be.
TEST(ToleranceSearch, TriesWhereItLooksAndDrawsTheResultWhole)
{
    const Asked asked;
    std::vector<std::size_t> boxes;
    const ToleranceResult result = asked.search(
        1.05,
        [&](const Settings&, std::span<const PixelBox> only) -> const Image& {
            boxes.push_back(only.size());
            return asked.black;
        },
        kLeastCertified);
    EXPECT_TRUE(result.holds);
    ASSERT_GE(boxes.size(), 2u);
    EXPECT_EQ(boxes.back(), 0u) << "the whole picture";
    boxes.pop_back();
    for (const std::size_t count : boxes) {
        EXPECT_GE(count, 1u);
        EXPECT_LE(count, std::size_t(kSize / kShadedBlock) * (kSize / kShadedBlock));
    }
    EXPECT_GT(result.certificate.forced, 0u) << "the certificate is the whole picture's";
}

// Of the whole picture, one pixel is no number, where no trial looks.
TEST(ToleranceSearch, WhatNoTrialSawStandsInTheWay)
{
    const Asked asked;
    Image broken = asked.black;
    broken.texels[0] = std::numeric_limits<float>::quiet_NaN(); // beside the sphere
    int whole = 0;
    const ToleranceResult result =
        asked.search(1.05, [&](const Settings&, std::span<const PixelBox> only) -> const Image& {
            whole += only.empty();
            return only.empty() ? broken : asked.black;
        });
    EXPECT_FALSE(result.holds);
    EXPECT_TRUE(isNearest(result.plan)) << "others were tried";
    EXPECT_EQ(whole, kMostSteps + 1);
    EXPECT_EQ(result.certificate.nonFinite, 1u);
}

} // namespace
} // namespace torrance
