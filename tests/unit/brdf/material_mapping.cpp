#include "brdf/material_mapping.h"

#include "brdf/shading_point.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

// Source E: rough = sqrt(sqrt(2 / (s + 2))).
TEST(MaterialMapping, ShininessIsSourceEsOwnRule)
{
    for (const double s : {0.0, 1.0, 10.0, 100.0, 1e4}) {
        EXPECT_NEAR(roughnessOfShininess(s), std::sqrt(std::sqrt(2.0 / (s + 2.0))), 1e-15);
        EXPECT_NEAR(shininessOf(roughnessOfShininess(s)), s, 1e-12 * (s + 1));
        EXPECT_NEAR(glossinessOf(roughnessOfGlossiness(s)), s, 1e-12 * (s + 1));
    }
}

// What lies below roughness 0.01 is one lobe, as everywhere (kMinAlpha).
TEST(MaterialMapping, StaysFiniteForMirrors)
{
    EXPECT_EQ(shininessOf(0.0), shininessOf(0.005));
    EXPECT_NEAR(shininessOf(0.0), 2.0 / (kMinAlpha * kMinAlpha) - 2.0, 1e-6);
    EXPECT_EQ(roughnessOfShininess(1e30), 0.01);
}

// Near the highlight cos(2 x)^g = cos(x)^(4 g): both fall as 1 - 2 g x^2.
TEST(MaterialMapping, GlossinessMakesAHighlightOfTheSameWidth)
{
    const double r = 0.3, x = 1e-3;
    const double byHalf = std::pow(std::cos(x), shininessOf(r)), byMirror = std::pow(std::cos(2 * x), glossinessOf(r));
    EXPECT_NEAR(byMirror / byHalf, 1.0, 1e-8);
    EXPECT_LT(byHalf, 0.9999);
}

TEST(MaterialMapping, R0RunsFromADielectricToAMetal)
{
    EXPECT_EQ(r0Of(0.0), 0.04);
    EXPECT_EQ(r0Of(1.0), 1.0);
    const MetallicColor metal = metallicOfR0(dvec3(1.0, 0.8, 0.4), 1.0, 0.5);
    EXPECT_EQ(metal.baseColor, dvec3(0.5, 0.4, 0.2)) << "a metal's F0 is R0 color";
    EXPECT_EQ(metallicOfR0(dvec3(1.0, 0.8, 0.4), 0.0, 0.5).baseColor, dvec3(1.0, 0.8, 0.4));
    for (const double metalness : {0.0, 1.0}) { // there and back
        const MetallicColor same = metallicOfR0(dvec3(0.3), metalness, r0Of(metalness));
        EXPECT_EQ(same.baseColor, dvec3(0.3));
        EXPECT_EQ(same.metallic, metalness);
    }
}

// Glass in air: ((1.5 - 1) / 2.5)^2.
TEST(MaterialMapping, ReflectanceOfTwoIndices)
{
    EXPECT_NEAR(reflectanceOfIndices(1.0, 1.5), 0.04, 1e-17);
    EXPECT_EQ(reflectanceOfIndices(1.5, 1.0), reflectanceOfIndices(1.0, 1.5));
    EXPECT_EQ(reflectanceOfIndices(1.3, 1.3), 0.0);
}

} // namespace
} // namespace torrance::brdf
