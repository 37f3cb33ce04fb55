#include "brdf/dfg.h"

#include "brdf/albedo.h"
#include "brdf/method.h"
#include "math/low_discrepancy.h"
#include "math/sampling.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

TEST(Dfg, FittedDiffuseWeightFollowsTheExactOne)
{
    for (int i = 0; i <= 200; ++i)
        EXPECT_NEAR(fittedDiffuseWeight(i / 200.0), schlickDiffuseWeight(i / 200.0), 6e-6) << i;
}

// Of a white surface, scale + bias, Lazarov prints 0.75 + 0.25 gloss, and of one of 0.04, face on, 0.015 + 0.0275
// gloss.
TEST(Dfg, LazarovHasTheEndsOfHisTalk)
{
    for (const double gloss : {0.0, 0.3, 0.7, 1.0}) {
        const double power = std::pow(8192.0, gloss);
        const double r = std::pow(2.0 / (power + 2.0), 0.25);
        const dvec3 terms = DFG_lazarov(1, r);
        EXPECT_NEAR(terms.x + terms.y, 0.75 + 0.25 * gloss, 1e-12);
        EXPECT_NEAR(0.04 * terms.x + terms.y, 0.015 + 0.0275 * gloss + gloss * std::exp2(-9.28), 1e-12);
    }
    EXPECT_EQ(DFG_lazarov(0.5, 1), DFG_lazarov(0.5, 0.9999)) << "gloss ends at 0";
    EXPECT_EQ(DFG_lazarov(0.5, 0), DFG_lazarov(0.5, 0.01)) << "and at 1";
}

// Evaluated by hand from the shader that the publication prints.
TEST(Dfg, KarisHasTheValuesOfHisShader)
{
    const dvec3 rough = DFG_karis_mobile(0.5, 1); // r = (0, 0.015, 0.468, -0.018)
    EXPECT_NEAR(rough.x, 0.468 - 1.04 * 0.015, 1e-15);
    EXPECT_NEAR(rough.y, 1.04 * 0.015 - 0.018, 1e-15);
    const dvec3 smooth = DFG_karis_mobile(0, 0); // r = (1, 0.0425, 1.04, -0.04), a004 = 1.0425
    EXPECT_NEAR(smooth.x, 1.04 - 1.04 * 1.0425, 1e-15);
    EXPECT_NEAR(smooth.y, 1.04 * 1.0425 - 0.04, 1e-15);
}

TEST(Dfg, NarkowiczHasTheValuesOfHisPolynomial)
{
    const dvec3 rough = DFG_narkowicz(1, 1); // gloss 0: no bias; delta = d0 + d2 + d5
    EXPECT_EQ(rough.y, 0);
    EXPECT_NEAR(rough.x, 0.6045 - 0.5228 + 0.1939, 1e-15);
    const dvec3 half = DFG_narkowicz(0.5, 0.25); // gloss 0.5
    const double bias = 0.9903 - 4.853 / 2 + 8.404 / 4 - 5.069 / 8;
    ASSERT_LT(bias, -0.1688 / 2 + 1.895 / 4);
    EXPECT_NEAR(half.y, bias, 1e-15);
    EXPECT_NEAR(half.x + half.y,
                std::min(1.0, 0.6045 + 1.699 / 2 - 0.5228 / 2 - 3.603 / 4 + 1.404 / 4 + 0.1939 / 4 + 2.661 / 8), 1e-15);
}

// E of D ggx with another V, from normals drawn from D: the mean of V NoL 4 VoH / NoH. 4096 points leave less than
// 1e-3, a hundredth of what is told apart here.
double sampledAlbedo(std::string_view visibility, double NoV, double r)
{
    const auto V = std::get<ScalarFormula>(findMethod(Slot::visibility, visibility)->formula);
    const dvec3 n(0, 0, 1), v(std::sqrt(1 - NoV * NoV), 0, NoV);
    constexpr std::uint32_t kCount = 4096;
    double sum = 0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const dvec3 h = sampleGgxNormal(dvec2(r * r), hammersley(i, kCount));
        const double VoH = glm::dot(v, h);
        const dvec3 l = 2 * VoH * h - v;
        if (VoH > 0 && l.z > 0)
            sum += V(makeShadingPoint(n, v, l, r)) * l.z * 4 * VoH / h.z;
    }
    return sum / kCount;
}

struct Fit
{
    DfgFormula formula;
    const char* visibility;
};

// The V that a row says its fit was made for is the one that it fits better than the material's own.
TEST(Dfg, FitsFollowTheVisibilityTheyWereMadeFor)
{
    for (const Fit& fit : {Fit{&DFG_karis_mobile, "schlick_half"}, Fit{&DFG_narkowicz, "smith_uncorr"}}) {
        double own = 0, correlated = 0;
        for (const double r : {0.3, 0.5, 0.7, 0.85, 1.0})
            for (const double NoV : {0.1, 0.25, 0.5, 0.75, 1.0}) {
                const dvec3 terms = fit.formula(NoV, r);
                const double E = terms.x + terms.y;
                own += std::pow(E - sampledAlbedo(fit.visibility, NoV, r), 2);
                correlated += std::pow(E - ggxAlbedo(NoV, r).albedo(), 2);
            }
        EXPECT_LT(own, correlated) << fit.visibility;
    }
}

TEST(Dfg, EveryTableIsARow)
{
    for (const DfgStorage& table : allDfgTables())
        EXPECT_NE(findMethod(Slot::dfg, table.id), nullptr) << table.id;
    for (const Method& method : allMethods()) {
        if (method.slot == Slot::dfg) {
            EXPECT_EQ(findDfgTable(method.id) != nullptr, method.file == "environment/dfg.glsl") << method.id;
        }
    }
}

} // namespace
} // namespace torrance::brdf
