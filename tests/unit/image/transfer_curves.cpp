#include "image/transfer_curves.h"

#include "image/srgb.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(TransferCurves, Gamma22IsUndoneByThePower22)
{
    for (double x = 1e-6; x < 10; x *= 1.7)
        EXPECT_NEAR(std::pow(transfer_gamma22(dvec3(x)).x, 2.2), x, 1e-14 * x);
    EXPECT_EQ(transfer_gamma22(dvec3(0, 1, 0)), dvec3(0, 1, 0));
}

TEST(TransferCurves, Gamma22MissesSrgbMostWhereSrgbIsStraight)
{
    // On the straight piece the difference is x^(1/2.2) - 12.92 x, whose derivative vanishes at
    // x = (2.2 * 12.92)^(-2.2/1.2) = 0.00216.
    const double worst = std::pow(2.2 * 12.92, -2.2 / 1.2);
    const double most = std::pow(worst, 1 / 2.2) - 12.92 * worst;
    for (double x = 0; x <= 1; x += 1e-4)
        EXPECT_LE(std::abs(transfer_gamma22(dvec3(x)).x - srgbEncode(x)), most) << x;
    EXPECT_NEAR(transfer_gamma22(dvec3(worst)).x - srgbEncode(worst), most, 1e-15);
    EXPECT_NEAR(most, 0.0335, 5e-5) << "what the header says";
}

TEST(TransferCurves, LinearChangesNothing)
{
    EXPECT_EQ(transfer_linear(dvec3(0.25, 3, 65504)), dvec3(0.25, 3, 65504));
    EXPECT_EQ(findTransferCurve("linear")->single(0.1f), 0.1f);
}

TEST(TransferCurves, DefineWhatNoLightIs)
{
    for (const TransferCurve& curve : allTransferCurves()) {
        EXPECT_EQ(curve.exact(dvec3(kNan, -1, -kInfinity)), dvec3(0)) << curve.id;
        EXPECT_EQ(curve.exact(dvec3(kInfinity)).x, kInfinity) << curve.id << ": clipped when it is stored";
        EXPECT_TRUE(std::isfinite(curve.exact(dvec3(65504)).x)) << curve.id;
        for (const float input : {static_cast<float>(kNan), -1.0f, -0.0f})
            EXPECT_EQ(curve.single(input), 0.0f) << curve.id << " of " << input;
    }
}

TEST(TransferCurves, FloatFollowsDoubleAndRises)
{
    for (const TransferCurve& curve : allTransferCurves()) {
        float last = -1.0f;
        for (float x = 1e-7f; x < 70000.0f; x *= 1.37f) {
            const double exact = curve.exact(dvec3(static_cast<double>(x))).x;
            // A power's rounding grows with its exponent's logarithm, at most ln(1e-7)/2.2: some ten units of 2^-24.
            EXPECT_NEAR(curve.single(x), exact, 1e-6 * exact) << curve.id << " at " << x;
            EXPECT_GT(curve.single(x), last) << curve.id << " at " << x;
            last = curve.single(x);
        }
    }
}

TEST(TransferCurves, AreFoundByIdOnly)
{
    EXPECT_EQ(findTransferCurve("srgb")->id, "srgb");
    EXPECT_EQ(findTransferCurve("gamma2.2"), nullptr);
}

} // namespace
} // namespace torrance
