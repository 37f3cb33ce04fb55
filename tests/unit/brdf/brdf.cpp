#include "brdf/brdf.h"

#include "brdf/albedo.h"
#include "brdf/condition.h"
#include "brdf/distribution.h"
#include "brdf/visibility.h"
#include "points.h"

#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

// The second form: glTF 2.0, Appendix B, "Implementation", transcribed term by term in a 64-bit mantissa.
dvec3 appendixB(const ShadingPoint& point)
{
    const long double pi = 3.14159265358979323846264338328L;
    const long double a2 = static_cast<long double>(point.alpha) * point.alpha;
    const long double NoL = point.NoL, NoV = point.NoV, VoH = point.VoH;
    const long double d = point.sin2H + static_cast<long double>(point.NoH) * point.NoH * a2; // NoH^2 (a^2 - 1) + 1
    const long double D = a2 / (pi * d * d);
    const long double V =
        0.5L / (NoL * std::sqrt(NoV * NoV * (1 - a2) + a2) + NoV * std::sqrt(NoL * NoL * (1 - a2) + a2));
    dvec3 result;
    for (int channel = 0; channel < 3; ++channel) {
        const long double base = point.baseColor[channel];
        const long double metallic = point.metallic;
        const long double black = 0;
        const long double cDiff = base + (black - base) * metallic;
        const long double f0 = 0.04L + (base - 0.04L) * metallic;
        const long double F = f0 + (1 - f0) * std::pow(std::abs(1 - VoH), 5.0L);
        result[channel] = static_cast<double>((1 - F) * cDiff / pi + F * D * V);
    }
    return result;
}

TEST(Brdf, GltfAtBothEndsOfMetallicIsTheSampleImplementationOfAppendixB)
{
    const Preset& gltf = *findPreset("gltf");
    for (ShadingPoint point : gridOfPoints())
        for (const double metallic : {0.0, 1.0}) {
            point.metallic = metallic;
            point.baseColor = dvec3(0.05, 0.5, 1.0);
            const dvec3 value = evaluateBrdf(gltf, point);
            const dvec3 expected = appendixB(point);
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(value[channel] / expected[channel], 1.0, 1e-12)
                    << point.NoV << ' ' << point.NoL << ' ' << metallic;
        }
}

// mix(dielectric_brdf, metal_brdf, metallic) is linear in metallic. The blended form of many viewers is not: it
// multiplies two blends.
TEST(Brdf, HalfMetalsAreTheMeanOfBothEnds)
{
    for (const char* id : {"gltf", "standard"})
        for (ShadingPoint point : gridOfPoints()) {
            const Preset& preset = *findPreset(id);
            point.baseColor = dvec3(0.9, 0.6, 0.3);
            point.metallic = 0;
            const dvec3 dielectric = evaluateBrdf(preset, point);
            point.metallic = 1;
            const dvec3 metal = evaluateBrdf(preset, point);
            point.metallic = 0.5;
            const dvec3 value = evaluateBrdf(preset, point);
            const dvec3 mean = (dielectric + metal) * 0.5;
            EXPECT_LE(glm::length(value - mean), 1e-14 * glm::length(mean));
        }
}

TEST(Brdf, ReflectsExactlyNothingBelowTheHorizonAndWithoutAHalfVector)
{
    for (const Preset& preset : allPresets()) {
        if (preset.id == "phong") // its ambient light knows no horizon
            continue;
        EXPECT_EQ(evaluateBrdf(preset, makeShadingPoint({0, 0, 1}, {0.2, 0.3, -0.1}, {0, 0.1, 0.9}, 0.4)), dvec3(0));
        EXPECT_EQ(evaluateBrdf(preset, makeShadingPoint({0, 0, 1}, {0, 0.1, 0.9}, {0.2, 0.3, -0.1}, 0.4)), dvec3(0));
        EXPECT_EQ(evaluateBrdf(preset, makeShadingPoint({0, 0, 1}, {0, 1, 0}, {0, -1, 0}, 0.5)), dvec3(0));
    }
}

TEST(Brdf, IsFiniteAtRoughnessZero)
{
    ShadingPoint mirror = makeShadingPoint({0, 0, 1}, {0, 0.28, 0.96}, {0, -0.28, 0.96}, 0.0);
    mirror.metallic = 1;
    // V = 1/(4 NoV NoL) for a mirror, D = 1/(pi kMinAlpha^2), F = 1
    const double expected = 1.0 / (4 * 0.96 * 0.96) / (kPi * kMinAlpha * kMinAlpha);
    EXPECT_NEAR(evaluateBrdf(*findPreset("gltf"), mirror).r / expected, 1.0, 1e-7);
}

TEST(Brdf, GltfIsReciprocal)
{
    const Preset& gltf = *findPreset("gltf");
    for (const double NoV : {0.01, 0.3, 0.9})
        for (const double NoL : {0.02, 0.5, 1.0})
            for (const double roughness : {0.05, 0.4, 1.0}) {
                ShadingPoint point = pointAt(NoV, NoL, 2.0, roughness);
                ShadingPoint swapped = makeShadingPoint(point.n, point.l, point.v, roughness);
                point.metallic = swapped.metallic = 0.3;
                EXPECT_NEAR(evaluateBrdf(gltf, point).r / evaluateBrdf(gltf, swapped).r, 1.0, 1e-13);
            }
}

// A white metal of any roughness returns all light once it is compensated (METHODS.md: any compensation at F0 = 1):
// over E of the single-scattering lobe, the factor is 1/E.
TEST(Brdf, StandardIsGltfOverItsAlbedoForAWhiteMetal)
{
    for (const double roughness : {0.1, 0.5, 1.0})
        for (const double NoV : {0.1, 0.5, 1.0}) {
            ShadingPoint point = pointAt(NoV, 0.6, 2.0, roughness);
            point.metallic = 1;
            const double single = evaluateBrdf(*findPreset("gltf"), point).r;
            const double compensated = evaluateBrdf(*findPreset("standard"), point).r;
            EXPECT_NEAR(compensated / single * ggxAlbedo(NoV, roughness).albedo(), 1.0, 1e-12)
                << roughness << ' ' << NoV;
        }
}

// GGX with alpha = 1, seen head-on, F = 1: E = 1 - ln 2 (METHODS.md). So a white metal gains by 1/(1 - ln 2) there.
TEST(Brdf, CompensationOfTheRoughestMetalIsKnown)
{
    ShadingPoint point = pointAt(1.0, 0.6, 0.0, 1.0);
    point.metallic = 1;
    const double gain = evaluateBrdf(*findPreset("standard"), point).r / evaluateBrdf(*findPreset("gltf"), point).r;
    EXPECT_NEAR(gain * (1 - std::log(2.0)), 1.0, 1e-6);
}

const ShadingPoint kTilted = makeShadingPoint({0, 0, 1}, {0.6, 0, 0.8}, {-0.6, 0, 0.8}, 0.5);

// Known condition numbers: that of a power is its exponent, that of a constant 0.
TEST(Condition, IsTheExponentOfAPower)
{
    const auto fourth = [](const ShadingPoint& p) { return dvec3(std::pow(p.perceptualRoughness, -4)); };
    EXPECT_NEAR(conditionNumber(fourth, kTilted), 4.0, 1e-6);
    const auto constant = [](const ShadingPoint&) { return dvec3(0.3); };
    EXPECT_EQ(conditionNumber(constant, kTilted), 0.0);
    const auto zero = [](const ShadingPoint&) { return dvec3(0); };
    EXPECT_EQ(conditionNumber(zero, kTilted), 0.0);
}

// n = z, NoL = l.z / |l|: d log NoL / d log l.x = -l.x^2 and d log NoL / d log l.z = 1 - l.z^2, whose magnitudes sum to
// 2 (1 - NoL^2). n's own z only scales n.
TEST(Condition, SeesVectorsThroughTheirNormalisation)
{
    const auto cosine = [](const ShadingPoint& p) { return dvec3(p.NoL); };
    EXPECT_NEAR(conditionNumber(cosine, kTilted), 2 * (1 - 0.64), 1e-6);
}

// Off the peak of a narrow GGX highlight D ~ a^2 / sin^4 h, and sin h is a difference of near-equal components of v and
// l.
TEST(Condition, GrowsWhereTheHighlightIsNarrow)
{
    const auto density = [](const ShadingPoint& p) { return dvec3(D_ggx(p)); };
    const dvec3 v(0.6, 0, 0.8), l(-0.6 + 1e-4, 0, 0.8);
    EXPECT_GT(conditionNumber(density, makeShadingPoint({0, 0, 1}, v, l, 0.01)), 1e3);
    EXPECT_LT(conditionNumber(density, makeShadingPoint({0, 0, 1}, v, l, 0.8)), 10);
}

// cos h of the angle t between v and l is cos(t/2): 1 - cos(t/2) = 2 sin^2(t/4), t^2/8 for small t, where 1 - VoH
// itself has no digit left.
TEST(ShadingPoint, KeepsOneLessVoHWhereVAndLMeet)
{
    const double angle = 1e-9;
    const ShadingPoint point = makeShadingPoint({0, 0, 1}, {0, 0, 1}, {std::sin(angle), 0, std::cos(angle)}, 0.5);
    EXPECT_NEAR(point.oneLessVoH / (angle * angle / 8), 1.0, 1e-6);
    EXPECT_EQ(1 - point.VoH, 0.0);
    const ShadingPoint opposite = makeShadingPoint({0, 0, 1}, {0, 1, 0}, {0, -1, 0}, 0.5);
    EXPECT_EQ(opposite.oneLessVoH, 1.0);
}

TEST(ShadingPoint, TakesVectorsOfAnyLength)
{
    const ShadingPoint huge = makeShadingPoint({0, 0, 1e300}, {0.6e250, 0, 0.8e250}, {0, 0, 5e-320}, 0.5);
    EXPECT_DOUBLE_EQ(huge.NoV, 0.8);
    EXPECT_DOUBLE_EQ(huge.NoL, 1.0);
}

} // namespace
} // namespace torrance::brdf
