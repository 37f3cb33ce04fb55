#include "brdf/environment.h"

#include "brdf/albedo.h"
#include "brdf/irradiance_window.h"
#include "brdf/phong_levels.h"
#include "math/frame.h"
#include "math/low_discrepancy.h"
#include "math/pixel_rotation.h"
#include "math/sampling.h"
#include "math/spherical_harmonics.h"

#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

std::vector<const Method*> rowsOf(Slot slot)
{
    std::vector<const Method*> rows;
    for (const Method& method : allMethods())
        if (method.slot == slot && method.ownModel.empty()) // those of sources are judged by themselves
            rows.push_back(&method);
    return rows;
}

dvec3 valueOf(const Method& method, const EnvironmentQuery& query)
{
    return std::get<EnvironmentFormula>(method.formula)(query);
}

EnvironmentQuery queryAt(double NoV, double r)
{
    EnvironmentQuery query;
    query.n = glm::normalize(dvec3(0.3, -0.5, 0.6));
    const dvec3 t = glm::normalize(glm::cross(query.n, dvec3(0, 1, 0)));
    query.v = query.n * NoV + t * std::sqrt(1 - NoV * NoV);
    query.perceptualRoughness = r;
    query.f0 = dvec3(1, 0.5, 0.04);
    query.samples = 4096;
    query.radiance = [](const dvec3&) { return dvec3(1, 2, 3); };
    return query;
}

TEST(EnvironmentRows, IrradianceOfAnEvenEnvironmentIsExact)
{
    for (const Method* method : rowsOf(Slot::environmentDiffuse)) {
        const dvec3 irradiance = valueOf(*method, queryAt(0.5, 1));
        EXPECT_LE(glm::length(irradiance - dvec3(1, 2, 3)), 1e-12) << method->id;
    }
}

// Of light that is linear in the direction, bands above 1 are empty: all methods give 2/3 of its slope, but for the
// mean.
TEST(EnvironmentRows, IrradianceOfALinearEnvironmentIsExact)
{
    for (const Method* method : rowsOf(Slot::environmentDiffuse)) {
        EnvironmentQuery query = queryAt(0.5, 1);
        query.radiance = [](const dvec3& d) { return dvec3(2 + d.x, 2 + d.y, 2 - 0.5 * d.z); };
        const double slope = method->id == "even" ? 0.0 : 2.0 / 3.0;
        const dvec3 expected = dvec3(2) + slope * dvec3(query.n.x, query.n.y, -0.5 * query.n.z);
        EXPECT_LE(glm::length(valueOf(*method, query) - expected), 1e-12) << method->id;
    }
}

// The furnace's closed form. 4096 points of a Hammersley set leave about 1/4096 times the logarithm of that, here of
// weights of about 1; filtered_importance draws normals that v does not see, whose weights vary by far more.
TEST(EnvironmentRows, AnEvenEnvironmentGivesTheFurnace)
{
    for (const Method* method : rowsOf(Slot::environmentSpecular))
        for (const double r : {0.1, 0.4, 0.7, 1.0})
            for (const double NoV : {0.2, 0.6, 0.95}) {
                const EnvironmentQuery query = queryAt(NoV, r);
                const AlbedoTerms terms = ggxAlbedo(NoV, r);
                const dvec3 expected = dvec3(1, 2, 3) * (query.f0 * terms.scale + terms.bias);
                const double tolerance = method->id == "filtered_importance" ? 1e-2 : 2e-3;
                EXPECT_LE(glm::length(valueOf(*method, query) - expected), tolerance * glm::length(expected))
                    << method->id << " r " << r << " NoV " << NoV;
            }
}

// Four samplers of one integral, and more samples bring each nearer to the common value.
TEST(EnvironmentRows, SampledMethodsConvergeToOneIntegral)
{
    EnvironmentQuery query = queryAt(0.4, 0.6);
    const dvec3 sun = glm::normalize(dvec3(-0.2, 0.1, 1));
    query.radiance = [sun](const dvec3& d) { return dvec3(0.2 + std::exp(8 * (glm::dot(d, sun) - 1))); };
    query.samples = 1 << 17;
    const dvec3 exact = Es_vndf_bounded(query);
    for (const Method* method : rowsOf(Slot::environmentSpecular)) {
        if (!drawsSamples(*method))
            continue;
        double errors[2];
        for (int i = 0; i < 2; ++i) {
            query.samples = i == 0 ? 32 : 8192;
            errors[i] = glm::length(valueOf(*method, query) / exact - dvec3(1));
        }
        EXPECT_LT(errors[1], 3e-3) << method->id;
        EXPECT_LT(errors[1], 0.2 * errors[0]) << method->id;
    }
}

// A sky and a sun of compact support; points even over the sun's cone. However wide the lobe, whether directions or
// points find the sun, its light counts once: as much as directions alone find of all light when they are many.
TEST(EnvironmentRows, LampsCountOnceWhoeverFindsThem)
{
    const dvec3 toSun = glm::normalize(dvec3(0.5, -0.2, 1));
    constexpr double kOneLessCosine = 0.02; // a cone of 11 degrees
    const auto sunAt = [&](const dvec3& d) {
        const double inside = std::max(0.0, 1.0 - (1.0 - glm::dot(d, toSun)) / kOneLessCosine);
        return dvec3(200, 150, 100) * inside * inside;
    };
    const double density = 1.0 / (2.0 * kPi * kOneLessCosine);
    std::vector<LampPoint> points;
    constexpr std::uint32_t kPoints = 1024;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
        const dvec3 d = frameAround(toSun) * sampleCone(kOneLessCosine, hammersley(i, kPoints));
        points.push_back({d, sunAt(d) / (density * kPoints), density});
    }
    for (const double r : {0.1, 0.3, 0.6, 1.0})
        for (const double NoV : {0.2, 0.7}) {
            EnvironmentQuery query = queryAt(NoV, r);
            query.radiance = [&](const dvec3& d) { return dvec3(0.4 + 0.2 * d.z) + sunAt(d); };
            query.samples = 1 << 17;
            const dvec3 exact = Es_vndf_bounded(query);
            query.lampPoints = points;
            query.lamps = [&](const dvec3& d) {
                return LampLight{sunAt(d), 1.0 - glm::dot(d, toSun) < kOneLessCosine ? density : 0.0};
            };
            for (const int samples : {256, 4096}) {
                query.samples = samples;
                EXPECT_LE(glm::length(Es_vndf_lamps(query) / exact - dvec3(1)), samples == 256 ? 2e-2 : 4e-3)
                    << "r " << r << " NoV " << NoV << " by " << samples;
            }
        }
}

TEST(EnvironmentRows, LampPointsAreFourADirectionWithinTheirBounds)
{
    EXPECT_EQ(lampPointCount(1), kLeastLampPoints);
    EXPECT_EQ(lampPointCount(64), 256);
    EXPECT_EQ(lampPointCount(1 << 20), kMostLampPoints);
}

TEST(EnvironmentRows, TheDominantDirectionIsTheMirrorsForSmoothSurfaces)
{
    EnvironmentQuery query = queryAt(0.3, 0.02);
    query.radiance = [](const dvec3& d) { return dvec3(1.5 + d.x + 0.3 * d.y * d.z); };
    const dvec3 mirror = Es_split_sum(query);
    EXPECT_LE(glm::length(Es_split_sum_dominant(query) / mirror - dvec3(1)), 1e-3); // alpha = 4e-4
    query.perceptualRoughness = 0.8;
    EXPECT_GT(glm::length(Es_split_sum_dominant(query) / Es_split_sum(query) - dvec3(1)), 0.01);
}

// The exponents of source E at rough = i / 7; rounded by hand.
TEST(PhongLevels, HoldTheExponentsOfTheirRoughness)
{
    EXPECT_NEAR(phongLevelExponent(1), 4800.0, 1e-9); // 2 * 7^4 - 2
    EXPECT_NEAR(phongLevelExponent(2), 298.125, 1e-10);
    EXPECT_NEAR(phongLevelExponent(7), 0.0, 1e-14);
    EXPECT_EQ(phongLevel(1.0), 7.0);
    EXPECT_NEAR(phongLevel(0.0), 0.07, 1e-14) << "roughness of 0.01 or more";
}

// The mean of the cosine under (s + 1) / (2 pi) cos^s is (s + 1) / (s + 2), that of its square (s + 1) / (s + 3).
TEST(PhongLevels, OfLowOrderLightAreTheClosedForm)
{
    EnvironmentQuery query = queryAt(0.6, 0.0);
    const dvec3 mirror = 2.0 * 0.6 * query.n - query.v;
    query.radiance = [&](const dvec3& d) {
        return dvec3(1, 1 + glm::dot(d, mirror), std::pow(glm::dot(d, mirror), 2));
    };
    const auto closedForm = [](double level) {
        const double s = 2.0 * std::pow(7.0 / level, 4) - 2.0;
        return dvec3(1, 1 + (s + 1) / (s + 2), (s + 1) / (s + 3));
    };
    const double schlick = std::pow(0.4, 5);
    const dvec3 F = query.f0 + (dvec3(1) - query.f0) * schlick;
    for (const double level : {1.0, 2.0, 4.0, 7.0}) {
        query.perceptualRoughness = level / 7.0;
        EXPECT_LE(glm::length(phongRadiance(query) - closedForm(level)), 1e-5) << level;
        EXPECT_LE(glm::length(Es_phong_levels(query) - F * closedForm(level)), 1e-5) << level;
    }
    query.perceptualRoughness = 2.25 / 7.0; // linear between levels
    EXPECT_LE(glm::length(phongRadiance(query) - (0.75 * closedForm(2) + 0.25 * closedForm(3))), 1e-5);
}

std::array<dvec3, 9> harmonicsOfSun(const dvec3& sun)
{
    constexpr std::array<int, 9> kBand = {0, 1, 1, 1, 2, 2, 2, 2, 2};
    std::array<dvec3, 9> harmonics;
    for (std::size_t i = 0; i < 9; ++i)
        harmonics[i] = dvec3(shBasis(sun)[i] * clampedCosineBand(kBand[i]) / kPi);
    return harmonics;
}

// A sun in one point: at the angle x = cos its irradiance is (1 + 2 w1 x + 5/8 w2 (3 x^2 - 1)) / 4 pi^2, whose least
// value a window of just the right width makes zero.
TEST(IrradianceWindow, IsJustWideEnoughForASun)
{
    const std::array<dvec3, 9> plain = harmonicsOfSun(glm::normalize(dvec3(0.4, -0.3, 0.5)));
    const std::array<dvec3, 9> windowed = windowedHarmonics(plain);
    const double w1 = windowed[2].r / plain[2].r, w2 = windowed[7].r / plain[7].r;
    EXPECT_EQ(windowed[0], plain[0]);
    EXPECT_NEAR((1 / w2 - 1) / (1 / w1 - 1), 9.0, 1e-9) << "(2 * 3)^2 / (1 * 2)^2";
    double least = 1;
    for (int i = 0; i <= 1000; ++i) {
        const double x = i / 500.0 - 1;
        least = std::min(least, 1 + 2 * w1 * x + 0.625 * w2 * (3 * x * x - 1));
    }
    EXPECT_NEAR(least, 0.0, 0.005) << "directions are tried in steps of 0.1: 1 - cos 0.1";
}

TEST(IrradianceWindow, LeavesLightAloneThatIsNowhereNegative)
{
    std::array<dvec3, 9> even = {};
    even[0] = dvec3(3);
    even[2] = dvec3(0.5, 0.1, 0);
    EXPECT_EQ(windowedHarmonics(even), even);
    const std::array<dvec3, 9> dark = {};
    EXPECT_EQ(windowedHarmonics(dark), dark);
}

TEST(PixelRotation, FillsTheSquareEvenly)
{
    int counts[8][8] = {};
    for (std::uint32_t y = 0; y < 64; ++y)
        for (std::uint32_t x = 0; x < 64; ++x) {
            const dvec2 p = pixelRotation(x, y, 3);
            ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
            ++counts[static_cast<int>(8 * p.x)][static_cast<int>(8 * p.y)];
        }
    double chi2 = 0; // of 64 cells of 64 points each: 63 degrees of freedom, 99.9 % below 104
    for (const auto& row : counts)
        for (const int count : row)
            chi2 += (count - 64.0) * (count - 64.0) / 64.0;
    EXPECT_LT(chi2, 104.0);
    EXPECT_NE(pixelRotation(1, 2, 0), pixelRotation(1, 2, 1));
}

} // namespace
} // namespace torrance::brdf
