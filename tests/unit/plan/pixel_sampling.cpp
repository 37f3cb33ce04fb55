#include "plan/pixel_sampling_plan.h"

#include "core/error.h"
#include "plan/level_plan.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

Settings reconstructed(int samples)
{
    Settings s = settings("standard");
    s.samples = samples;
    s.methods.pixelSampling = brdf::findMethod(brdf::Slot::pixelSampling, "reconstructed");
    return s;
}

TEST(PixelSamplingPlan, OneShadingAPixelIsOnePictureAtItsOwnLevelOfDetail)
{
    EXPECT_EQ(pictureCount(reconstructed(4)), 1);
    EXPECT_EQ(levelBias(reconstructed(4)), 0.0);
    Settings s = settings("standard");
    s.samples = 4;
    EXPECT_EQ(pictureCount(s), 4);
    EXPECT_EQ(levelBias(s), -1.0);
}

TEST(PixelSamplingPlan, OtherNumbersThanFourAreRefused)
{
    const Scene scene = sceneWith(Material{});
    EXPECT_NO_THROW(makePlan(scene, reconstructed(4)));
    for (const int samples : {1, 2, 16})
        try {
            makePlan(scene, reconstructed(samples));
            FAIL() << samples;
        } catch (const Error& e) {
            EXPECT_EQ(e.exitCode, ExitCode::usage);
            EXPECT_NE(std::string(e.what()).find("--samples 4"), std::string::npos) << e.what();
        }
}

TEST(PixelSamplingPlan, AnalyticShapesAreRefused)
{
    Scene scene = sceneWith(Material{});
    scene.shapes.push_back({.material = 0});
    EXPECT_THROW(makePlan(scene, reconstructed(4)), Error);
}

} // namespace
} // namespace torrance::test
