#include "brdf/sheen.h"

#include "math/quadrature.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

// v and l at the same angle on both sides of n: h is n, and at 0.6, 0.8 on one side h is tilted by it.
ShadingPoint retroreflection(double cosine, double roughness)
{
    const double sine = std::sqrt(1 - cosine * cosine);
    return makeShadingPoint({0, 0, 1}, {sine, 0, cosine}, {sine, 0, cosine}, roughness);
}

// alpha = 1: D = 3 sin / (2 pi); at v = l = h, cosine 0.6, sine 0.8: D = 1.2 / pi, and Ashikhmin's denominator is
// 4 (1.2 - 0.36) = 3.36.
TEST(Sheen, AshikhminsLobeIsItsFormula)
{
    EXPECT_NEAR(S_ashikhmin(retroreflection(0.6, 1.0)), 1.2 / kPi / 3.36, 1e-15);
}

// The facets' area seen from above is 1: 2 pi (2 + p)/(2 pi) int sin^p cos sin dtheta = 1 for every p = 1/alpha. D is
// Ashikhmin's lobe times its denominator.
TEST(Sheen, DistributionCoversTheSurface)
{
    const QuadratureRule sines = gaussLegendre(400, 0.0, 1.0);
    for (const double r : {0.2, 0.5, 1.0}) {
        const double area = integrate(sines, [&](double sine) { // cos sin dtheta = sine d(sine)
            const double cosine = std::sqrt(1 - sine * sine);
            return 2 * kPi * sine * S_ashikhmin(retroreflection(cosine, r)) * 4 * (2 * cosine - cosine * cosine);
        });
        EXPECT_NEAR(area, 1.0, 1e-9) << r;
    }
}

// Lambda at alpha = 1 and cosine 1/2, step by step: x^c = 0.5^0.19823 = 0.8716193, L = 21.5473 / (1 + 3.82987 *
// 0.8716193) - 0.98880 - 4.32054 = -0.3424512, Lambda = 0.7100278; and both halves of the fit meet there.
TEST(Sheen, CharliesMaskingIsTheFitOfThePaper)
{
    const double D = 3 * std::sqrt(0.75) / (2 * kPi);
    EXPECT_NEAR(S_charlie(retroreflection(0.5, 1.0)), D / (4 * 0.25 * (1 + 2 * 0.7100278)), 2e-8);
    const double below = S_charlie(retroreflection(0.5 - 1e-9, 0.6)),
                 above = S_charlie(retroreflection(0.5 + 1e-9, 0.6));
    EXPECT_NEAR(below / above, 1.0, 1e-7);
}

// kLeastDenominator: far below any cosine that a surface is seen at, finite where their product is nothing.
TEST(Sheen, IsFiniteWhereBothCosinesVanish)
{
    ShadingPoint point = retroreflection(0.5, 0.0);
    point.NoV = point.NoL = 1e-200;
    EXPECT_TRUE(std::isfinite(S_charlie(point)));
    EXPECT_TRUE(std::isfinite(S_ashikhmin(point)));
    point.NoL = 0;
    EXPECT_EQ(S_charlie(point), 0.0);
    EXPECT_EQ(S_ashikhmin(point), 0.0);
}

} // namespace
} // namespace torrance::brdf
