#include "image/tone_curves.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double farthest(const dvec3& a, const dvec3& b)
{
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

struct Case
{
    const char* curve;
    dvec3 input;
    dvec3 expected;
};

// Computed apart from this program, with Python's doubles, from the sources named in tone_curves.h as they print the
// formulas (powers written out, no common subexpressions).
const Case kCases[] = {
    {"khronos_neutral", {0.18, 0.18, 0.18}, {0.14, 0.14, 0.14}},
    {"khronos_neutral", {0.02, 0.7, 0.3}, {0.0025, 0.6825, 0.2825}},
    {"khronos_neutral", {0.9, 0.05, 0.4}, {0.833345388788427, 0.0189854190192598, 0.354310112453623}},
    {"khronos_neutral", {12, 3, 0.5}, {0.994965034965035, 0.711869081416365, 0.633231316541734}},
    {"aces_hill", {0.18, 0.18, 0.18}, {0.105591247228931, 0.105591247228931, 0.105590191316458}},
    {"aces_hill", {0.9, 0.05, 0.4}, {0.630253122671084, 0.018011585092355, 0.286676067825849}},
    {"aces_hill", {12, 3, 0.5}, {1.0, 0.893174709981151, 0.648108918130975}},
    {"aces_narkowicz", {0.18, 0.05, 0.9}, {0.26689892038949686, 0.044283069913142535, 0.7805478725419619}},
    {"aces_narkowicz", {12, 3, 0.5}, {1, 0.9537426408746844, 0.6163069544364508}},
    {"agx", {0.18, 0.18, 0.18}, {0.214467430707203, 0.214532668620548, 0.214536728268133}},
    {"agx", {0.9, 0.05, 0.4}, {0.607079502008031, 0.115868806513689, 0.390783292654135}},
    {"agx", {12, 3, 0.5}, {1.0, 0.841459530003505, 0.596701820054359}},
    {"reinhard", {12, 3, 0.5}, {12.0 / 13.0, 0.75, 1.0 / 3.0}},
    {"none", {12, 3, 0.5}, {12, 3, 0.5}},
};

TEST(ToneCurves, AgreeWithAnIndependentComputation)
{
    for (const Case& c : kCases)
        EXPECT_LE(farthest(findToneCurve(c.curve)->exact(c.input), c.expected), 1e-13)
            << c.curve << " at " << c.input.x << " " << c.input.y << " " << c.input.z;
}

TEST(ToneCurves, NeutralMovesBaseColoursByTheReflectanceItTakesOutOnly)
{
    // The specification's purpose: between 0.08 and 0.8 a colour comes out as it went in, less 0.04.
    for (double red = 0.08; red <= 0.8; red += 0.01)
        EXPECT_LE(farthest(tone_khronos_neutral(dvec3(red, 0.08, 0.3)), {red - 0.04, 0.04, 0.26}), 1e-15) << red;
}

TEST(ToneCurves, NeutralIsContinuousWhereItsPiecesMeet)
{
    for (const double knee : {0.08, 0.8})
        EXPECT_LE(farthest(tone_khronos_neutral(dvec3(knee - 1e-12)), tone_khronos_neutral(dvec3(knee + 1e-12))),
                  1e-11);
}

// How far float may lie from double, absolute, on results in [0, 1]. One rounding is 2^-24 = 6e-8. Neutral and Reinhard
// do about ten on values of at most 1. ACES doubles its errors in the output matrix. AgX sums polynomial terms of up to
// 40 that cancel: 40 * 2^-24 * 1.35 (outset) * 2.2 (power) = 7e-6 per rounding, of which a few add.
double floatBound(std::string_view curve)
{
    return curve == "agx" ? 2e-5 : 2e-6;
}

TEST(ToneCurves, FloatFollowsDouble)
{
    for (const ToneCurve& curve : allToneCurves())
        for (double stops = -14; stops < 14; stops += 0.37) {
            const vec3 color = vec3(1.0f, 0.3f, 0.06f) * static_cast<float>(std::exp2(stops));
            const dvec3 exact = curve.exact(dvec3(color));
            const double scale = std::max({exact.x, exact.y, exact.z, 1.0});
            EXPECT_LE(farthest(dvec3(curve.single(color)), exact), floatBound(curve.id) * scale)
                << curve.id << " at " << stops << " stops";
        }
}

TEST(ToneCurves, DefineWhatNoRadianceIs)
{
    for (const ToneCurve& curve : allToneCurves()) {
        const dvec3 black = curve.exact(dvec3(0.0));
        EXPECT_EQ(farthest(curve.exact(dvec3(kNan)), black), 0.0) << curve.id;
        EXPECT_EQ(farthest(curve.exact(dvec3(-1.0)), black), 0.0) << curve.id;
        EXPECT_EQ(farthest(curve.exact(dvec3(kInfinity)), curve.exact(dvec3(kMaxToneInput))), 0.0) << curve.id;
        EXPECT_EQ(curve.single(vec3(static_cast<float>(kInfinity))),
                  curve.single(vec3(static_cast<float>(kMaxToneInput))))
            << curve.id;
        EXPECT_EQ(curve.single(vec3(static_cast<float>(kNan))), vec3(black)) << curve.id;
        EXPECT_TRUE(std::isfinite(curve.single(vec3(static_cast<float>(kInfinity), 0.0f, 0.0f)).x)) << curve.id;
    }
}

TEST(ToneCurves, StayInRangeAndRiseWithExposure)
{
    for (const ToneCurve& curve : allToneCurves()) {
        if (curve.id == "none")
            continue;
        double last = -1.0;
        for (double grey = 1e-6; grey < 1e30; grey *= 1.3) {
            const dvec3 toned = curve.exact(dvec3(grey));
            EXPECT_GE(toned.x, last - 2e-16) << "less than a rounding of 1: " << curve.id << " at " << grey;
            EXPECT_LE(toned.x, 1.0) << curve.id << " at " << grey;
            last = toned.x;
        }
        EXPECT_GE(curve.exact(dvec3(65504.0)).x, 0.99) << curve.id << ": the largest half float is white";
    }
}

TEST(ToneCurves, AreFoundByIdOnly)
{
    EXPECT_EQ(findToneCurve("agx")->id, "agx");
    EXPECT_EQ(findToneCurve("AgX"), nullptr);
}

// Bit by bit, NaN and infinity included; the lanes are of different pieces of the curves.
TEST(ToneCurves, OfFourColoursAreThoseOfEach)
{
    const float values[] = {0.0f,
                            1e-6f,
                            0.05f,
                            0.08f,
                            0.3f,
                            0.7599f,
                            0.76f,
                            0.8f,
                            1.0f,
                            12.0f,
                            1e30f,
                            -1.0f,
                            static_cast<float>(kInfinity),
                            static_cast<float>(kNan)};
    constexpr std::size_t kCount = std::size(values);
    for (const ToneCurve& curve : allToneCurves())
        for (std::size_t i = 0; i < kCount * kCount; ++i) {
            const auto value = [&](std::size_t number) { return values[number % kCount]; };
            Float4 red, green, blue;
            for (std::size_t lane = 0; lane < 4; ++lane) {
                red[lane] = value(i + lane);
                green[lane] = value(i / kCount + 3 * lane);
                blue[lane] = value(5 * i + 7 * lane);
            }
            const Float4 r = red, g = green, b = blue;
            curve.four(red, green, blue);
            for (int lane = 0; lane < 4; ++lane) {
                const vec3 expected = curve.single({r[lane], g[lane], b[lane]});
                EXPECT_EQ(red[lane], expected.x) << curve.id;
                EXPECT_EQ(green[lane], expected.y) << curve.id;
                EXPECT_EQ(blue[lane], expected.z) << curve.id;
            }
        }
}

} // namespace
} // namespace torrance
