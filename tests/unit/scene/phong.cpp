// Phong's parameters and the microfacet model's, both ways.
#include "scene/phong.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

TEST(Phong, AShininessAndItsRoughnessHaveTheSameLobe)
{
    // Walter et al. 2007: s = 2 / alpha^2 - 2. alpha = 1, 1/2, 1/10 by hand.
    EXPECT_DOUBLE_EQ(perceptualRoughnessOfShininess(0.0), 1.0);
    EXPECT_NEAR(perceptualRoughnessOfShininess(6.0), std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(perceptualRoughnessOfShininess(198.0), std::sqrt(0.1), 1e-15);
    EXPECT_DOUBLE_EQ(perceptualRoughnessOfShininess(-5.0), 1.0) << "counts as 0";
    EXPECT_EQ(shininessOfPerceptualRoughness(0.0), std::numeric_limits<double>::infinity());
}

TEST(Phong, HalfWidthsAgreeWhereLobesAreNarrow)
{
    // Independent of the formula: (cos t)^s = 1/2 and the Beckmann exponential exp(-tan^2 t / alpha^2) = 1/2.
    for (const double s : {200.0, 1000.0, 10000.0}) {
        const double r = perceptualRoughnessOfShininess(s);
        const double blinn = std::acos(std::pow(0.5, 1.0 / s));
        const double beckmann = std::atan(r * r * std::sqrt(std::log(2.0)));
        EXPECT_NEAR(blinn / beckmann, 1.0, 2.0 / s) << s;
    }
}

TEST(Phong, GoesBothWays)
{
    for (const double s : {0.0, 1.0, 10.0, 96.078431, 1000.0, 1e6})
        EXPECT_NEAR(shininessOfPerceptualRoughness(perceptualRoughnessOfShininess(s)), s, 1e-9 * (s + 1.0));
    for (const double f0 : {0.0, 0.02, 0.04, 0.08, 0.17, 0.5})
        EXPECT_NEAR(reflectanceOfIor(iorOfReflectance(f0)), f0, 1e-15);
    EXPECT_DOUBLE_EQ(reflectanceOfIor(1.5), 0.04);
    EXPECT_NEAR(iorOfReflectance(0.02), 1.33, 1e-3) << "water";
}

} // namespace
} // namespace torrance
