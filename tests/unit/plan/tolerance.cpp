#include "plan/tolerance_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace torrance {
namespace {

using brdf::Slot;

const brdf::Method* method(Slot slot, const char* id)
{
    return brdf::findMethod(slot, id);
}

// A table of one cell: costs and errors are those that a test names.
struct Row
{
    Slot slot;
    const char* id;
    double cost, error;
};

MethodTable tableOf(std::initializer_list<Row> rows)
{
    MethodTable table;
    table.grid = {{0.0, 1.0}, {0.0, 1.0}, {0.0, 1.0}};
    for (const Row& row : rows) {
        MethodRow& added = table.rows.emplace_back();
        added.method = method(row.slot, row.id);
        added.truth = "the integral";
        // Costs are the ratio's to what the row was drawn in turn with; the median by itself wandered with the machine.
        const double wandered = 1.1 * row.cost, ratio = row.cost / 100.0;
        added.cost =
            MethodCost{.nanoseconds = {wandered, wandered, wandered}, .ratio = {ratio, ratio, ratio}, .frames = 10};
        added.error.emplace().mean = row.error;
        added.error->cells.assign(table.grid.cells(), row.error);
    }
    return table;
}

MethodTable usual()
{
    return tableOf({{Slot::environmentDiffuse, "even", 80, 0.5},
                    {Slot::environmentDiffuse, "sh4", 90, 0.08},
                    {Slot::environmentDiffuse, "irradiance_cube", 100, 0.0},
                    {Slot::environmentSpecular, "even", 90, 0.6},
                    {Slot::environmentSpecular, "split_sum", 100, 0.12},
                    {Slot::environmentSpecular, "vndf_bounded", 3300, 0.05},
                    {Slot::environmentSpecular, "vndf_lamps", 8500, 0.01},
                    {Slot::dfg, "table", 100, 0.0},
                    {Slot::dfg, "narkowicz", 95, 0.01}});
}

const brdf::Preset& standard()
{
    return *brdf::findPreset("standard");
}

// Half of the light by the body and half by the lobe.
const std::vector<SeenSurface> kSurfaces = {
    {.perceptualRoughness = 0.4, .NoV = 0.7, .f0 = 0.5, .body = 0.5, .lobe = 0.5, .spheres = 0.0}};
constexpr LadderScene kLit = {.environment = true, .even = false, .lamps = true, .spheres = false};

TolerancePlan planFor(double tolerance, const LadderScene& scene = kLit, std::vector<Slot> fixed = {})
{
    return planTolerance(usual(), {.mean = tolerance, .percentile99 = {}}, standard(), fixed, kSurfaces, scene);
}

const MethodLadder& ladderFor(const TolerancePlan& plan, Slot slot)
{
    return *std::ranges::find(plan.ladders, slot, &MethodLadder::slot);
}

TEST(MethodLadder, IsAFrontOfCostAndError)
{
    for (const MethodLadder& ladder : planFor(0.01).ladders)
        for (std::size_t i = 1; i < ladder.rungs.size(); ++i) {
            EXPECT_GT(ladder.rungs[i].cost, ladder.rungs[i - 1].cost);
            EXPECT_LT(ladder.rungs[i].error, ladder.rungs[i - 1].error);
        }
}

// What is cheaper by the median alone is no choice beside what is nearer.
TEST(MethodLadder, PartsOnlyCostsWhoseIntervalsLieApart)
{
    const auto idsWith = [](double low, double high) {
        MethodTable table = usual();
        table.rows[1].cost->ratio = {0.90, low, high}; // sh4, beside irradiance_cube's 1
        const auto ladder =
            ladderOf(table, Slot::environmentDiffuse, *standard()[Slot::environmentDiffuse], kSurfaces, kLit);
        std::vector<std::string_view> ids;
        for (const Rung& rung : ladder->rungs)
            ids.push_back(rung.method->id);
        return ids;
    };
    using Ids = std::vector<std::string_view>;
    EXPECT_EQ(idsWith(0.85, 0.95), (Ids{"sh4", "irradiance_cube"}));
    EXPECT_EQ(idsWith(0.85, 1.01), (Ids{"irradiance_cube"}));
    EXPECT_EQ(idsWith(0.78, 0.91), (Ids{"irradiance_cube"})) << "the greater half counts both ways";
    EXPECT_EQ(idsWith(-HUGE_VAL, HUGE_VAL), (Ids{"irradiance_cube"})) << "too few frames say nothing";
}

TEST(MethodLadder, WhatDoesWithoutATableIsCheaperUnlessItIsDearerBeyondDoubt)
{
    LadderScene even = kLit;
    even.even = true;
    const auto cheapestWith = [&](double ratio) {
        MethodTable table = usual();
        table.rows.back().cost->ratio = {ratio, ratio - 0.05, ratio + 0.05}; // narkowicz, beside the table's 1
        return ladderOf(table, Slot::dfg, *standard()[Slot::dfg], kSurfaces, even)->rungs.front().method->id;
    };
    EXPECT_EQ(cheapestWith(0.99), "narkowicz");
    EXPECT_EQ(cheapestWith(1.04), "narkowicz");
    EXPECT_EQ(cheapestWith(1.06), "table");
}

// Directions cost what vndf_bounded takes longer than the cheapest, points what vndf_lamps takes longer than that; all
// by ratios to the slot's own method, which took 110 where its row says 100.
TEST(MethodLadder, CostsOfSamplesAreTheTables)
{
    const TolerancePlan plan = planFor(0.01);
    const auto& rungs = ladderFor(plan, Slot::environmentSpecular).rungs;
    const auto costOf = [&](int samples) { return std::ranges::find(rungs, samples, &Rung::samples)->cost / 1.1; };
    const double direction = (3300.0 - 100.0) / 64, point = (8500.0 - 3300.0) / 256;
    EXPECT_NEAR(costOf(64), 8500.0, 1e-6);
    EXPECT_NEAR(costOf(16), 100.0 + 16 * direction + 64 * point, 1e-6);
    EXPECT_NEAR(costOf(1024), 100.0 + 1024 * direction + 512 * point, 1e-6);
    EXPECT_EQ(Settings().environmentSamples, kTableSamples) << "what the table's rows were drawn with";
}

TEST(MethodLadder, WeighsErrorsByTheSlotsShareOfTheLight)
{
    const TolerancePlan plan = planFor(0.01);
    EXPECT_DOUBLE_EQ(ladderFor(plan, Slot::environmentSpecular).rungs.front().error, 0.5 * 0.12);
    EXPECT_DOUBLE_EQ(ladderFor(plan, Slot::environmentDiffuse).rungs.front().error, 0.5 * 0.08);
}

TEST(MethodLadder, TakesTheTruthsNoiseOutOfErrors)
{
    MethodTable table = usual();
    table.rows[1].error->noise = 0.08 / (0.798 / 2.13); // all of it is noise
    EXPECT_NEAR(expectedError(table, table.rows[1], kSurfaces), 0.0, 1e-9);
    table.rows[1].error->noise *= 0.6;
    EXPECT_NEAR(expectedError(table, table.rows[1], kSurfaces), 0.5 * 0.08 * 0.8, 1e-9);
}

TEST(MethodLadder, ReadsTheCellOfTheSurface)
{
    MethodTable table = usual();
    std::vector<double>& cells = table.rows[4].error->cells; // two reflectances, two roughnesses, one column
    cells = {0.1, 0.2, 0.3, 0.4};
    const auto errorOf = [&](double f0, double roughness) {
        const SeenSurface surface = {
            .perceptualRoughness = roughness, .NoV = 0.7, .f0 = f0, .body = 0.0, .lobe = 1.0, .spheres = 0.0};
        return expectedError(table, table.rows[4], std::span(&surface, 1));
    };
    EXPECT_DOUBLE_EQ(errorOf(0.1, 0.1), 0.1);
    EXPECT_DOUBLE_EQ(errorOf(0.1, 0.9), 0.2);
    EXPECT_DOUBLE_EQ(errorOf(0.9, 0.1), 0.3);
    EXPECT_DOUBLE_EQ(errorOf(0.9, 0.9), 0.4);
    cells[3] = std::nan("");
    EXPECT_DOUBLE_EQ(errorOf(0.9, 0.9), 0.12) << "a black cell says nothing: the mean stands for it";
}

TEST(TolerancePlan, TakesTheCheapestWithinTheSlotsShare)
{
    const TolerancePlan coarse = planFor(0.4), fine = planFor(0.01);
    EXPECT_EQ(ladderFor(coarse, Slot::environmentDiffuse).taken().method->id, "sh4"); // 4 % of an eighth of 40 %
    EXPECT_EQ(ladderFor(fine, Slot::environmentDiffuse).taken().method->id, "irradiance_cube");
    EXPECT_EQ(ladderFor(coarse, Slot::dfg).taken().method->id, "table") << "a fit is for even light alone";
    EXPECT_EQ(ladderFor(fine, Slot::dfg).taken().method->id, "table");
    EXPECT_EQ(ladderFor(fine, Slot::environmentSpecular).taken().method->id, "split_sum");
}

TEST(TolerancePlan, RefusesWhatIsOutsideItsDomainAndSaysSo)
{
    const TolerancePlan plan = planFor(1.0);
    for (const Slot slot : {Slot::environmentDiffuse, Slot::environmentSpecular}) {
        const MethodLadder& ladder = ladderFor(plan, slot);
        EXPECT_EQ(std::ranges::count(ladder.rungs, method(slot, "even"), &Rung::method), 0);
        EXPECT_EQ(std::ranges::count(ladder.refused, method(slot, "even"), &RefusedMethod::method), 1);
    }
    LadderScene full = kLit;
    full.lamps = false;
    const TolerancePlan without = planFor(0.01, full);
    const auto has = [](const TolerancePlan& p, const char* id) {
        const auto& rungs = ladderFor(p, Slot::environmentSpecular).rungs;
        return std::ranges::any_of(rungs, [&](const Rung& rung) { return rung.method->id == id; });
    };
    EXPECT_TRUE(!has(without, "vndf_lamps") && has(without, "vndf_bounded")) << "no place behind the lights";
    EXPECT_TRUE(has(plan, "vndf_lamps") && !has(plan, "vndf_bounded")) << "one method that draws directions";
    bool said = false;
    for (const Remark& remark : remarksOf(without))
        said |= remark.choice == "not vndf_lamps";
    EXPECT_TRUE(said);
}

// What needs nothing gets nothing: no map, no table.
TEST(TolerancePlan, AnEvenEnvironmentIsItsMean)
{
    LadderScene even = kLit;
    even.even = true;
    const Settings drawn = settingsOf(planFor(0.1, even), Settings{.methods = standard()});
    EXPECT_EQ(drawn.methods.environmentDiffuse->id, "even");
    EXPECT_EQ(drawn.methods.environmentSpecular->id, "even");
    EXPECT_EQ(drawn.methods.dfg->id, "narkowicz");
}

TEST(TolerancePlan, LeavesAloneWhatWasAskedForByNameAndWhatHasNothingToDo)
{
    const TolerancePlan fixed = planFor(0.4, kLit, {Slot::environmentDiffuse});
    EXPECT_EQ(std::ranges::count(fixed.ladders, Slot::environmentDiffuse, &MethodLadder::slot), 0);
    EXPECT_TRUE(planFor(0.4, {}).ladders.empty());
    EXPECT_EQ(std::ranges::count(fixed.ladders, Slot::areaLight, &MethodLadder::slot), 0);
}

TEST(TolerancePlan, StepsUpToWhatTheTableSaysIsEnough)
{
    TolerancePlan plan = planFor(0.01);
    EXPECT_FALSE(isNearest(plan));
    ASSERT_TRUE(stepUp(plan, 0.08));
    // Half of the light: 0.5 0.01 sqrt(64 / n) <= 0.75 %, so that n >= 28.4.
    EXPECT_EQ(ladderFor(plan, Slot::environmentSpecular).taken().method->id, "vndf_lamps");
    EXPECT_EQ(ladderFor(plan, Slot::environmentSpecular).taken().samples, 32);
    // Three times what was expected: 3 0.5 0.01 sqrt(64 / n) <= 0.75 %, so that n >= 256.
    ASSERT_TRUE(stepUp(plan, 2.999 * 0.5 * 0.01 * std::sqrt(2.0)));
    EXPECT_EQ(ladderFor(plan, Slot::environmentSpecular).taken().samples, 256);
    // At least one step, whatever is expected; and none above the highest.
    ASSERT_TRUE(stepUp(plan, 1e-6));
    EXPECT_EQ(ladderFor(plan, Slot::environmentSpecular).taken().samples, 512);
    for (const int samples : {1024, 2048, 4096}) {
        EXPECT_FALSE(isNearest(plan));
        ASSERT_TRUE(stepUp(plan, 1e-6));
        EXPECT_EQ(ladderFor(plan, Slot::environmentSpecular).taken().samples, samples);
    }
    EXPECT_EQ(ladderFor(plan, Slot::environmentSpecular).taken().samples, kLadderSamples.back());
    EXPECT_TRUE(isNearest(plan));
    EXPECT_FALSE(stepUp(plan, 0.5));
}

TEST(TolerancePlan, ThePixelsBlameGoesBeforeTheTables)
{
    TolerancePlan plan = planFor(0.4); // sh4 and the split sum, of which more is expected
    ASSERT_TRUE(stepUp(plan, 0.5, "environment_diffuse"));
    EXPECT_EQ(ladderFor(plan, Slot::environmentDiffuse).taken().method->id, "irradiance_cube");
    EXPECT_EQ(ladderFor(plan, Slot::environmentSpecular).taken().method->id, "split_sum");
    ASSERT_TRUE(stepUp(plan, 0.5, "environment_diffuse")); // which is at its highest now
    EXPECT_NE(ladderFor(plan, Slot::environmentSpecular).taken().method->id, "split_sum");
}

TEST(TolerancePlan, WritesItsChoiceIntoTheSettings)
{
    TolerancePlan plan = planFor(0.01);
    stepUp(plan, 0.08);
    const Settings drawn = settingsOf(plan, Settings{.methods = standard()});
    EXPECT_EQ(drawn.methods.environmentSpecular->id, "vndf_lamps");
    EXPECT_EQ(drawn.environmentSamples, 32);
    EXPECT_EQ(drawn.methods.distribution, standard().distribution) << "the model stays as it was asked for";
}

// Rungs have the cost of whole frames, of which what all of them share counts once.
TEST(TolerancePlan, ExpectsTheCostOfItsChoice)
{
    TolerancePlan plan = {{.mean = 0.01, .percentile99 = {}}, {}};
    constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();
    const auto ladder = [&](Slot slot, double cheap, double dear) {
        plan.ladders.push_back(
            {.slot = slot, .rungs = {{nullptr, 0, cheap, 0.1}, {nullptr, 0, dear, 0.0}}, .refused = {}});
    };
    ladder(Slot::environmentSpecular, 100.0, 900.0);
    ladder(Slot::dfg, 95.0, 102.0);
    ladder(Slot::textureFilter, kNotMeasured, kNotMeasured);
    EXPECT_EQ(expectedCost(plan), 100.0);
    plan.ladders[1].at = 1;
    EXPECT_EQ(expectedCost(plan), 107.0);
    plan.ladders[0].at = plan.ladders[2].at = 1;
    EXPECT_EQ(expectedCost(plan), 907.0);
}

// What a picture itself says of a slot takes part as what the table says does.
TEST(TolerancePlan, AMeasuredSlotBeginsWithinItsShareAndGoesUpAsOthersDo)
{
    constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();
    MethodLadder filters;
    filters.slot = Slot::textureFilter;
    filters.rungs = {{method(Slot::textureFilter, "nearest_level"), 0, kNotMeasured, 0.02},
                     {method(Slot::textureFilter, "trilinear"), 0, kNotMeasured, 0.002},
                     {method(Slot::textureFilter, "trilinear_exact"), 0, kNotMeasured, 0.0}};
    const auto taken = [](const TolerancePlan& plan) { return settingsOf(plan, {}).methods.textureFilter->id; };
    for (const auto& [tolerance, id] :
         {std::pair(0.5, "nearest_level"), {0.02, "trilinear"}, {0.01, "trilinear_exact"}}) {
        TolerancePlan plan = planFor(tolerance);
        addLadder(plan, filters, kLit);
        EXPECT_EQ(taken(plan), id) << tolerance;
    }
    TolerancePlan plan = planFor(0.02);
    addLadder(plan, filters, kLit);
    ASSERT_TRUE(stepUp(plan, 0.05, "texture_filter"));
    EXPECT_EQ(taken(plan), "trilinear_exact");
    const std::string reason = remarksOf(plan).back().reason;
    EXPECT_NE(reason.find("measured on this picture"), std::string::npos) << reason;
}

} // namespace
} // namespace torrance
