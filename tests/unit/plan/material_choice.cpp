// Which materials take cheaper methods once all of them were measured with several.
#include "plan/material_choice.h"

#include "plan/settings.h"

#include <array>
#include <gtest/gtest.h>
#include <vector>

namespace torrance {
namespace {

LightMethods samples(int count)
{
    Settings settings = {.methods = *brdf::findPreset("standard")};
    settings.environmentSamples = count;
    return lightMethodsOf(settings);
}

/// Materials 0 and 1, each on half of the pixels.
MaterialTrial trial(int count, double cost, double error0, double error1)
{
    return {samples(count), cost, {{0, {error0, 0.5}}, {1, {error1, 0.5}}}};
}

constexpr std::array kBoth = {0, 1};

std::map<int, int> chosen(const std::vector<MaterialTrial>& trials, double most, std::span<const int> free = kBoth)
{
    std::map<int, int> counts;
    for (const auto& [material, own] :
         cheaperMaterials(trials.back(), std::span(trials).first(trials.size() - 1), free, most))
        counts[material] = own.environmentSamples;
    return counts;
}

using Counts = std::map<int, int>;

const std::vector<MaterialTrial> kTrials = {trial(4, 100.0, 0.020, 0.002), trial(16, 200.0, 0.006, 0.001),
                                            trial(64, 600.0, 0.003, 0.0005)};

TEST(CheaperMaterials, AddUpToNoMoreThanIsLeft)
{
    EXPECT_EQ(chosen(kTrials, 0.0055), (Counts{{1, 4}})) << "0.003 + 0.002";
    EXPECT_EQ(chosen(kTrials, 0.0045), (Counts{{1, 16}})) << "0.003 + 0.001";
    EXPECT_EQ(chosen(kTrials, 0.0085), (Counts{{0, 16}, {1, 4}})) << "0.006 + 0.002";
    EXPECT_EQ(chosen(kTrials, 0.0225), (Counts{{0, 4}, {1, 4}}));
    EXPECT_EQ(chosen(kTrials, 0.0036), Counts{}) << "as it was found: 0.0035";
    EXPECT_EQ(chosen(kTrials, 0.001), Counts{}) << "which is off by more";
}

TEST(CheaperMaterials, ThoseThatWereAskedForStay)
{
    constexpr std::array kFirst = {0};
    EXPECT_EQ(chosen(kTrials, 0.0075, kFirst), (Counts{{0, 16}}));
    EXPECT_EQ(chosen(kTrials, 0.0055, kFirst), Counts{});
}

// 5 % of what a frame costs, over its pixels.
TEST(CheaperMaterials, LittleIsNotWorthAPipeline)
{
    const auto saving = [](double pixels) {
        std::vector<MaterialTrial> trials = kTrials;
        for (MaterialTrial& t : trials) {
            t.errors[0].pixels = 1.0 - pixels;
            t.errors[1].pixels = pixels;
        }
        return chosen(trials, 0.0055);
    };
    EXPECT_EQ(saving(0.0601), (Counts{{1, 4}})) << "500 of 600 ns on 6.01 % of the pixels: 5.008 %";
    EXPECT_EQ(saving(0.0599), Counts{});
}

// What draws better with less is taken whatever is left.
TEST(CheaperMaterials, NearerAndCheaperIsTaken)
{
    EXPECT_EQ(chosen({trial(4, 100.0, 0.020, 0.0001), trial(64, 600.0, 0.003, 0.0005)}, 0.001), Counts{})
        << "all together are off by more than is allowed all the same";
    EXPECT_EQ(chosen({trial(4, 100.0, 0.020, 0.0001), trial(64, 600.0, 0.003, 0.0005)}, 0.0035), (Counts{{1, 4}}));
    EXPECT_EQ(chosen({trial(4, 700.0, 0.0, 0.0), trial(64, 600.0, 0.003, 0.0005)}, 0.1), Counts{}) << "dearer";
}

} // namespace
} // namespace torrance
