#include "brdf/specular_antialiasing.h"

#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

TEST(SpecularAntialiasingFormulas, ToksvigShrinksThePowerOfBlinnsLobe)
{
    // Toksvig's own numbers: power 100, a mean of length 0.99, so 0.99 / (0.99 + 100 * 0.01) of it.
    NormalFootprint footprint;
    footprint.alpha = std::sqrt(2.0 / 102.0);
    footprint.meanLength = 0.99;
    const double power = 2 / (AA_toksvig(footprint) * AA_toksvig(footprint)) - 2;
    EXPECT_NEAR(power, 100 * 0.99 / 1.99, 1e-10);
    footprint.meanLength = 1;
    EXPECT_NEAR(AA_toksvig(footprint), footprint.alpha, 1e-15);
    footprint.meanLength = 0;
    EXPECT_EQ(AA_toksvig(footprint), 1) << "normals in all directions";
}

TEST(SpecularAntialiasingFormulas, TokuyoshiAddsTheNormalsVarianceUpToItsCap)
{
    NormalFootprint footprint;
    footprint.alpha = 0.3;
    EXPECT_EQ(AA_tokuyoshi(footprint), 0.3);
    footprint.dndx = dvec3(0.1, 0, 0);
    footprint.dndy = dvec3(0, 0.2, 0);
    EXPECT_NEAR(AA_tokuyoshi(footprint), std::sqrt(0.09 + 0.05 / kPi), 1e-15);
    footprint.dndx = dvec3(2, 0, 0);
    EXPECT_NEAR(AA_tokuyoshi(footprint), std::sqrt(0.09 + kKernelCap), 1e-15);
    footprint.alpha = 0.95;
    EXPECT_EQ(AA_tokuyoshi(footprint), 1) << "no rougher than 1";
}

} // namespace
} // namespace torrance::brdf
