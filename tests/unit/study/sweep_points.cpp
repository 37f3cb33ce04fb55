#include "study/sweep_points.h"

#include "study/model_error.h"
#include "study/rounded_point.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

using brdf::Slot;
using gpu::Precision;

TEST(RoundedPoint, RoundsAsTheFormatsDo)
{
    EXPECT_EQ(roundedTo(0.1, Precision::fp32), static_cast<double>(0.1f));
    EXPECT_EQ(roundedTo(0.1, Precision::fp64), 0.1);
    EXPECT_EQ(roundedTo(1 + 0x1p-11, Precision::fp16), 1.0) << "ties to even";
    EXPECT_EQ(roundedTo(1 + 3 * 0x1p-11, Precision::fp16), 1 + 0x1p-9);
    EXPECT_EQ(roundedTo(1.4 * 0x1p-24, Precision::fp16), 0x1p-24) << "subnormal";
    EXPECT_EQ(roundedTo(0.4 * 0x1p-24, Precision::fp16), 0.0);
    EXPECT_EQ(leastNormal(Precision::fp16), 0x1p-14);
    EXPECT_EQ(unitRoundoff(Precision::fp32), 0x1p-24);
}

TEST(RoundedPoint, MovesCosinesByUnitsAndLeavesExactZeros)
{
    const brdf::ShadingPoint point = mirrorPoint(0.5, 0.3);
    const brdf::ShadingPoint up = geometryRounded(point, Precision::fp32, 1);
    EXPECT_EQ(up.NoV, 0.5 + 0x1p-24) << "the unit of numbers from 1/2 to 1";
    EXPECT_EQ(up.NoH, 1.0) << "no cosine is above 1";
    EXPECT_EQ(geometryRounded(point, Precision::fp16, -1).NoH, 1 - 0x1p-10);
    brdf::ShadingPoint exact = point;
    exact.sin2H = 0;
    EXPECT_EQ(geometryRounded(exact, Precision::fp32, 1).sin2H, 0.0);
}

TEST(SweepAxes, ReachTheEndsAndTheIndexOfVacuum)
{
    const SweepAxes axes = sweepAxes(Slot::distribution, 16);
    EXPECT_EQ(axes.rows.front(), 0.0);
    EXPECT_EQ(axes.rows.back(), 1.0);
    EXPECT_EQ(axes.cosines.front(), 1e-4);
    EXPECT_EQ(axes.cosines.back(), 1.0);
    const std::vector<double> indices = sweepAxes(Slot::fresnel, 16).rows;
    EXPECT_TRUE(std::ranges::is_sorted(indices));
    EXPECT_NE(std::ranges::find(indices, 1.0), indices.end());
    EXPECT_TRUE(std::ranges::any_of(indices, [](double n) { return n != 1 && std::abs(n - 1) < 2e-6; }));
}

TEST(SweepPoints, ReachTheHighlightAndGrazingLight)
{
    const auto points = sweepPoints(Slot::distribution, 0.5, 0.1, Precision::fp32);
    const auto sine = [](const brdf::ShadingPoint& p) { return std::sqrt(p.sin2H); };
    for (const double wanted : {1e-7, 1e-5, 1e-3, 0.1})
        EXPECT_TRUE(std::ranges::any_of(points, [&](const auto& p) { return std::abs(sine(p) / wanted - 1) < 0.01; }))
            << wanted;
    const auto lights = sweepPoints(Slot::visibility, 0.5, 0.1, Precision::fp32);
    EXPECT_TRUE(std::ranges::any_of(lights, [](const auto& p) { return std::abs(p.NoL - 1e-4) < 1e-12; }));
    for (const auto& point : lights)
        EXPECT_GT(point.NoL, 0);
}

TEST(SweepPoints, GiveFresnelTermsTheSurfaceOfTheirIndex)
{
    const auto points = sweepPoints(Slot::fresnel, 0.3, 1.5, Precision::fp64);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_NEAR(points[0].f0.x, 0.04, 1e-15);
    EXPECT_EQ(points[0].k, dvec3(0));
    EXPECT_NEAR(points[0].VoH, 0.3, 1e-12);
    // ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2), n = 2.9, k = 3
    EXPECT_NEAR(points[1].f0.z, (1.9 * 1.9 + 9) / (3.9 * 3.9 + 9), 1e-15);
}

// The tint of f82 is the exact reflectance over Schlick's at the cosine 1/7: there the two terms agree.
TEST(SweepPoints, GiveMetalsTheirTint)
{
    const SweepAxes axes = {.cosines = {1.0 / 7.0, 0.3}, .rows = {1.5}, .leastLight = 0.0};
    const auto errors =
        modelErrors(*brdf::findMethod(Slot::fresnel, "f82"), *brdf::findMethod(Slot::fresnel, "exact_conductor"), axes);
    EXPECT_LT(errors[0].error, 1e-12);
    EXPECT_GT(errors[1].error, 1e-6);
}

TEST(ModelError, ResolvesWhatARowApproximates)
{
    const auto ids = [](Slot slot, std::string_view id) {
        std::vector<std::string_view> names;
        for (const brdf::Method* method : approximatedMethods(*brdf::findMethod(slot, id)))
            names.push_back(method->id);
        return names;
    };
    EXPECT_EQ(ids(Slot::distribution, "ggx_textbook"), std::vector<std::string_view>{"ggx"});
    EXPECT_EQ(ids(Slot::fresnel, "schlick"), (std::vector<std::string_view>{"exact_dielectric", "exact_conductor"}));
    EXPECT_TRUE(ids(Slot::distribution, "ggx").empty());
}

// G of `implicit` is NoL NoV: at NoV = NoL = 0.1, h = n, where V-shaped grooves hide nothing (2 NoH NoV / VoH = 2), it
// is a hundredth, and its V is 1/4 instead of 25.
TEST(ModelError, IsNoneWhereBothAgreeAndNearlyAllWhereOneIsAHundredth)
{
    const SweepAxes axes = {.cosines = {0.1}, .rows = {0.5}, .leastLight = 0.0};
    const auto cells =
        modelErrors(*brdf::findMethod(Slot::diffuse, "eon_approx"), *brdf::findMethod(Slot::diffuse, "eon"),
                    {.cosines = {0.5}, .rows = {0.0}, .leastLight = 0.0});
    EXPECT_LT(cells.front().error, 1e-12) << "roughness 0 is Lambert in both";
    EXPECT_GT(modelErrors(*brdf::findMethod(Slot::visibility, "implicit"),
                          *brdf::findMethod(Slot::visibility, "vcavity"), axes)
                  .front()
                  .error,
              0.98);
}

} // namespace
} // namespace torrance
