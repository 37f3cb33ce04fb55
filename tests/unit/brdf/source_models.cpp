// The source systems in double: values at a point, and which of the three laws (positivity, Helmholtz' reciprocity,
// energy conservation) each keeps.
#include "brdf/brdf.h"
#include "points.h"

#include <gtest/gtest.h>
#include <ostream>

namespace torrance::brdf {
namespace {

struct KnownValue
{
    const char* preset;
    const char* option; // of the model, set to 1 where it is a quirk
    double parameter;
    dvec3 brdf;
};

// For GoogleTest's names of failed cases.
std::ostream& operator<<(std::ostream& out, const KnownValue& known)
{
    return out << known.preset << ' ' << known.option;
}

// tests/unit/brdf/source_values.py, an independent writing of docs/sources.md.
const KnownValue kKnownValues[] = {
    {"ue4-direct", "", 0, {0.2903261435911747, 0.18004109752389802, 0.050657594228506894}},
    {"ue4-direct", "double-fresnel", 0, {0.19328522111265062, 0.11313669585646874, 0.024105606387419765}},
    {"phong", "", 0, {0.8522928234002837, 0.47521243476013, 0.09813204611997622}},
    {"cook-torrance-beckmann", "", 0, {0.1717692154671679, 0.10797578463461106, 0.02508389657393979}},
    {"cook-torrance-beckmann", "pi-denominator", 0, {0.17496619214040493, 0.1099190799603435, 0.025773510552167627}},
    {"cook-torrance-beckmann", "energy-sketch", 0, {0.1487745050066062, 0.09343755889841265, 0.022006324328018675}},
    {"ggx-burley", "", 0, {0.38849115534319595, 0.2640619279659709, 0.13963270058874583}},
    {"schlick-beckmann", "", 0, {0.29044320119297146, 0.18130063999534293, 0.04669346916022844}},
    {"schlick-beckmann", "double-fresnel", 0, {0.23306524306631077, 0.14174168013268695, 0.0309939188301843}},
    {"smith-r", "", 0, {0.9769555887446426, 0.5467777688678066, 0.11659994899097073}},
    {"torrance-sparrow-blinn", "", 0, {0.16830160889013973, 0.09815187001329562, 0.0280021311364515}},
    {"torrance-sparrow-blinn", "reflectivity", 0.3, {0.25102571096283005, 0.1408540211683154, 0.030682331373800796}},
};

class SourceValue : public testing::TestWithParam<KnownValue>
{
};

TEST_P(SourceValue, IsThatOfAnIndependentWriting)
{
    const KnownValue& known = GetParam();
    Preset preset = *findPreset(known.preset);
    if (const ModelOption* option = findModelOption(preset, known.option)) {
        if (option->isQuirk())
            preset.options.*std::get<bool ModelOptions::*>(option->member) = true;
        else
            preset.options.*std::get<double ModelOptions::*>(option->member) = known.parameter;
    }
    ShadingPoint point = makeShadingPoint({0, 0, 1}, {0.3, 0.1, 0.8}, {-0.4, 0.2, 0.7}, 0.3);
    point.metallic = 0.25;
    point.baseColor = dvec3(0.9, 0.5, 0.1);
    const dvec3 value = evaluateBrdf(preset, point);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(value[c] / known.brdf[c], 1.0, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Sources, SourceValue, testing::ValuesIn(kKnownValues));

// Without n.l the light of ggx-burley is divided by it; a weight of 1 says that the model has no cosine of its own.
TEST(SourceQuirk, NoCosineLeavesTheBrdfAndDropsTheCosine)
{
    Preset letter = *findPreset("ggx-burley");
    letter.options.noCosine = true;
    const ShadingPoint point = pointAt(0.6, 0.3, 1.0, 0.4);
    const BrdfTerms with = evaluateTerms(*findPreset("ggx-burley"), point), without = evaluateTerms(letter, point);
    EXPECT_EQ(with.brdf, without.brdf);
    EXPECT_NEAR(without.response().r * 0.3 / with.response().r, 1.0, 1e-15);
}

// Radiance that leaves along v in a furnace of radiance 1: the midpoint rule over cos^2 and azimuth.
double furnace(const Preset& preset, double NoV, double perceptualRoughness, double metallic)
{
    constexpr int kRings = 96, kSpokes = 96;
    double sum = 0;
    for (int i = 0; i < kRings; ++i)
        for (int j = 0; j < kSpokes; ++j) {
            ShadingPoint point =
                pointAt(NoV, std::sqrt((i + 0.5) / kRings), (j + 0.5) * kPi / kSpokes, perceptualRoughness);
            point.metallic = metallic;
            sum += evaluateTerms(preset, point).response().r / point.NoL;
        }
    return sum * kPi / (kRings * kSpokes); // of pi, the integral of cos over the hemisphere
}

// Response per cosine: the BRDF, also where a source keeps its cosine elsewhere.
dvec3 trueBrdf(const Preset& preset, const dvec3& v, const dvec3& l, const ShadingPoint& like)
{
    ShadingPoint point = makeShadingPoint(like.n, v, l, like.perceptualRoughness);
    point.baseColor = dvec3(0.9, 0.5, 0.1);
    point.metallic = 0.3;
    return evaluateTerms(preset, point).response() / point.NoL;
}

class SourceLaws : public testing::TestWithParam<const Preset*>
{
};

TEST_P(SourceLaws, NothingIsNegativeOrNotFinite)
{
    for (const ShadingPoint& point : gridOfPoints()) {
        const BrdfTerms terms = evaluateTerms(*GetParam(), point);
        for (const dvec3& c : {terms.brdf, terms.specular, terms.diffuse, terms.F0, terms.F}) {
            ASSERT_TRUE(std::isfinite(c.r + c.g + c.b));
            ASSERT_TRUE(c.r >= 0 && c.g >= 0 && c.b >= 0);
        }
        ASSERT_TRUE(terms.D >= 0 && terms.G >= 0 && terms.G1 >= 0 && terms.V >= 0 && terms.weight >= 0);
        ASSERT_TRUE(std::isfinite(terms.D + terms.V));
    }
}

TEST_P(SourceLaws, ReciprocityIsKeptWhereTheRowSaysSo)
{
    const Preset& preset = *GetParam();
    double worst = 0;
    for (const ShadingPoint& point : gridOfPoints()) {
        const double there = trueBrdf(preset, point.v, point.l, point).g,
                     back = trueBrdf(preset, point.l, point.v, point).g;
        worst = std::max(worst, std::abs(there - back) / std::max(there, back));
    }
    if (preset.model->reciprocal)
        EXPECT_LE(worst, 1e-6); // alpha = 1e-4 magnifies the last digits of n.h 2e8 times
    else
        EXPECT_GT(worst, 0.1);
}

TEST_P(SourceLaws, EnergyIsKeptWhereTheRowSaysSo)
{
    const Preset& preset = *GetParam();
    double most = 0;
    for (const double NoV : {0.05, 0.2, 0.5, 0.8, 1.0})
        for (const double perceptualRoughness : {0.4, 0.7, 1.0})
            for (const double metallic : {0.0, 0.5, 1.0})
                most = std::max(most, furnace(preset, NoV, perceptualRoughness, metallic));
    if (preset.model->gainsEnergy)
        EXPECT_GT(most, 1.005);
    else
        EXPECT_LE(most, 1.001) << "the quadrature is good to a thousandth";
}

std::vector<const Preset*> sourcePresets()
{
    std::vector<const Preset*> presets;
    for (const Preset& preset : allPresets())
        if (!isComposed(preset))
            presets.push_back(&preset);
    return presets;
}

INSTANTIATE_TEST_SUITE_P(Sources, SourceLaws, testing::ValuesIn(sourcePresets()),
                         [](const auto& instance) { return std::string(instance.param->model->id); });

} // namespace
} // namespace torrance::brdf
