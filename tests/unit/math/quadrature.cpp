#include "math/quadrature.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

TEST(GaussLegendre, KnowsTheThreePointRule)
{
    // Abramowitz & Stegun table 25.4: nodes 0 and +-sqrt(3/5), weights 8/9 and 5/9.
    const QuadratureRule rule = gaussLegendre(3, -1.0, 1.0);
    EXPECT_NEAR(rule.nodes[0], -std::sqrt(0.6), 1e-15);
    EXPECT_EQ(rule.nodes[1], 0.0);
    EXPECT_NEAR(rule.nodes[2], std::sqrt(0.6), 1e-15);
    EXPECT_NEAR(rule.weights[0], 5.0 / 9.0, 1e-15);
    EXPECT_NEAR(rule.weights[1], 8.0 / 9.0, 1e-15);
}

TEST(GaussLegendre, IsExactForPolynomialsOfDegreeTwoNMinusOne)
{
    for (const int n : {1, 2, 5, 16, 65, 256}) {
        const QuadratureRule rule = gaussLegendre(n, 0.0, 2.0);
        for (const int degree : {0, n - 1, 2 * n - 1}) {
            const double exact = 2.0 / (degree + 1); // of (x/2)^degree over [0, 2]
            EXPECT_NEAR(integrate(rule, [&](double x) { return std::pow(0.5 * x, degree); }), exact, 2e-15 * n)
                << n << " points, degree " << degree;
        }
        EXPECT_GT(rule.nodes.front(), 0.0);
        EXPECT_LT(rule.nodes.back(), 2.0);
    }
}

TEST(GaussLegendre, MissesTheFirstDegreeThatItCannotHold)
{
    // Remainder for x^4 on [-1, 1] with two points: 8/45 (Abramowitz & Stegun 25.4.30).
    EXPECT_NEAR(2.0 / 5.0 - integrate(gaussLegendre(2, -1.0, 1.0), [](double x) { return x * x * x * x; }), 8.0 / 45.0,
                1e-15);
}

} // namespace
} // namespace torrance
