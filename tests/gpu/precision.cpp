// The same formula in 16, 32 and 64 bits on the device.
#include "brdf/method.h"
#include "passes/precision_probe.h"
#include "test_device.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

using gpu::Precision;

double relativeError(std::string_view slotId, std::string_view id, Precision precision, const brdf::ShadingPoint& point)
{
    const brdf::Method* method = brdf::findMethod(*brdf::findSlot(slotId), id);
    const ProbeTerm term = makeProbeTerm(*method);
    const auto made = makePrecisionProbe(test::device(), test::shaders(), term, precision);
    const double exact = term.formula(point).x;
    return std::abs(probe(test::device(), std::get<PrecisionProbe>(made), std::vector{point}).front().x / exact - 1);
}

brdf::ShadingPoint somePoint()
{
    return brdf::makeShadingPoint({0, 0, 1}, {0.6, 0, 0.8}, {-0.5, 0.2, 0.7}, 0.5);
}

// An error of u = 2^-p stands for p bits; the formulas have some ten operations, whose errors neither add up to more
// than twenty u nor all vanish.
TEST(Precision, EachHasTheErrorOfItsBits)
{
    for (const auto& [precision, bits] : {std::pair(Precision::fp16, 11), {Precision::fp32, 24}, {Precision::fp64, 53}})
    {
        if (!test::device().computes(precision))
            continue;
        const double error = relativeError("distribution", "ggx", precision, somePoint()) +
                             relativeError("visibility", "smith_corr", precision, somePoint()) +
                             relativeError("fresnel", "exact_dielectric", precision, somePoint());
        EXPECT_LT(error, 60 * std::ldexp(1.0, -bits)) << gpu::precisionName(precision);
        EXPECT_GT(error, std::ldexp(1.0, -bits - 4)) << gpu::precisionName(precision);
    }
}

// 1 / (pi alpha^2) = 5e5 passes a half's greatest number, 65504.
TEST(Precision, TheHighlightOfASmoothSurfaceOverflowsAHalf)
{
    if (!test::device().computes(Precision::fp16))
        GTEST_SKIP() << "no 16-bit floats";
    const auto mirror = brdf::makeShadingPoint({0, 0, 1}, {0.6, 0, 0.8}, {-0.6, 0, 0.8}, 0.028);
    EXPECT_TRUE(std::isinf(relativeError("distribution", "ggx", Precision::fp16, mirror)));
}

std::string refusal(std::string_view slotId, std::string_view id, Precision precision)
{
    const ProbeTerm term = makeProbeTerm(*brdf::findMethod(*brdf::findSlot(slotId), id));
    const auto made = makePrecisionProbe(test::device(), test::shaders(), term, precision);
    return std::holds_alternative<std::string>(made) ? std::get<std::string>(made) : "";
}

TEST(Precision, SaysWhatItCannotEvaluate)
{
    if (test::device().computes(Precision::fp64)) {
        EXPECT_EQ(refusal("distribution", "beckmann", Precision::fp64),
                  "exp, uintBitsToFloat have no 64-bit form in GLSL");
        EXPECT_EQ(refusal("fresnel", "exact_dielectric", Precision::fp64), "") << "includes exp, and does not call it";
    }
    if (test::device().computes(Precision::fp16)) {
        EXPECT_EQ(refusal("distribution", "beckmann", Precision::fp16), "uintBitsToFloat has no 16-bit form in GLSL");
        EXPECT_EQ(refusal("dfg", "table", Precision::fp16), "it looks up a table of 32-bit floats");
    }
    EXPECT_EQ(refusal("distribution", "beckmann", Precision::fp32), "");
}

} // namespace
} // namespace torrance
