#include "study/method_table_file.h"

#include "core/error.h"
#include "study/chart_methods.h"
#include "study/slot_trial.h"

#include "tests/shipped_table.h"
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <limits>
#include <sstream>

namespace torrance {
namespace {

// Every method there is, on the least grid; numbers of our own.
MethodTable wholeTable()
{
    MethodTable table = {.program = "p",
                         .date = "2026-11-27",
                         .processor = "cpu",
                         .cores = 2,
                         .system = "s",
                         .device = "d",
                         .driver = "v 1",
                         .environment = "studio",
                         .grid = {.roughnesses = {0.1, 1.0}, .reflectances = {0.04, 0.9}, .cosines = {0.1, 0.5, 1.0}},
                         .rows = {}};
    for (const brdf::Method& method : brdf::allMethods())
        table.rows.push_back({.method = &method, .truth = "t", .note = "", .cost = {}, .error = {}});
    table.rows.front().cost = {{10.0, 9.0, 11.0}, {1.5, -HUGE_VAL, HUGE_VAL}, 7};
    table.rows.front().error = MethodError{
        .mean = 0.25, .rms = 0.5, .worst = HUGE_VAL, .flip = 0.125, .noise = 0.0, .cells = {}, .cellWorst = {}};
    table.rows.front().error->cells.assign(table.grid.cells(), 0.0625);
    table.rows.front().error->cells[3] = std::numeric_limits<double>::quiet_NaN();
    return table;
}

std::string refusal(const std::string& text)
{
    try {
        parseMethodTable(text, "t.json");
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::input);
        return error.what();
    }
    return "";
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

TEST(MethodTableFile, ReadsWhatItWrote)
{
    const MethodTable written = wholeTable(), read = parseMethodTable(jsonText(asJson(written)), "t.json");
    EXPECT_EQ(read.device, "d");
    EXPECT_EQ(read.driver, "v 1");
    EXPECT_EQ(read.cores, 2);
    EXPECT_EQ(read.grid, written.grid);
    ASSERT_EQ(read.rows.size(), written.rows.size());
    const MethodRow& row = read.rows.front();
    EXPECT_EQ(row.method, written.rows.front().method);
    ASSERT_TRUE(row.cost && row.error);
    EXPECT_EQ(row.cost->nanoseconds.high, 11.0);
    EXPECT_EQ(row.cost->ratio.low, -HUGE_VAL) << "what too few frames do not say";
    EXPECT_EQ(row.cost->frames, 7u);
    EXPECT_EQ(row.error->worst, HUGE_VAL);
    EXPECT_EQ(row.error->cells[2], 0.0625);
    EXPECT_TRUE(std::isnan(row.error->cells[3]));
    EXPECT_TRUE(row.error->cellWorst.empty());
    EXPECT_FALSE(read.rows.back().cost || read.rows.back().error);
}

TEST(MethodTableFile, RefusesWhatIsDamaged)
{
    const std::string good = jsonText(asJson(wholeTable()));
    EXPECT_EQ(refusal(good), "");
    EXPECT_NE(refusal("{"), "");
    EXPECT_NE(refusal(replaced(good, "torrance-methods/1", "torrance-methods/9")).find("torrance-methods/9"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(good, "\"id\": \"gltf\"", "\"id\": \"gltg\"")).find("model/gltg"), std::string::npos);
    EXPECT_NE(refusal(replaced(good, "\"id\": \"ue4_direct\"", "\"id\": \"gltf\"")).find("lacks model/ue4_direct"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(good, "\"mean\": 0.25", "\"mean\": -0.25")).find("negative"), std::string::npos);
    EXPECT_NE(refusal(replaced(good, "0.0625,", "")).find("7 cells, and the grid 8"), std::string::npos);
    EXPECT_NE(refusal(replaced(good, "\"median\": 10.0", "\"median\": 12.0")).find("median"), std::string::npos);
    EXPECT_NE(refusal(replaced(good, "0.1, 0.5, 1.0", "0.1, 1.0, 0.5")).find("above the one before"),
              std::string::npos);
}

TEST(MethodTableFile, IsOfOneDevice)
{
    const MethodTable table = wholeTable();
    EXPECT_NO_THROW(requireDevice(table, "t.json", "d", "v 1"));
    EXPECT_THROW(requireDevice(table, "t.json", "e", "v 1"), Error);
    EXPECT_THROW(requireDevice(table, "t.json", "d", "v 2"), Error);
}

// What is shipped is of the registry as it is: torrance calibrate -o assets/methods.measured.json
TEST(MethodTableFile, IsShippedWhole)
{
    const MethodTable table = test::shippedTable();
    EXPECT_NE(table.device.find("llvmpipe"), std::string::npos);
    for (const MethodRow& row : table.rows) {
        const std::string name(row.method->id);
        EXPECT_EQ(row.cost.has_value(), whyNotOnSpheres(*row.method).empty()) << name;
        const bool judged = whyNotOnSpheres(*row.method).empty() && truthOf(*row.method).kind != TruthKind::none;
        EXPECT_EQ(row.error.has_value(), judged) << name;
        EXPECT_EQ(row.truth, truthOf(*row.method).kind == TruthKind::none ? "" : truthOf(*row.method).text) << name;
    }
}

TEST(ChartMethods, DrawsAFrontForEachTruth)
{
    MethodTable table = wholeTable();
    const auto set = [&](const char* id, const char* truth, double cost, double error) {
        for (MethodRow& row : table.rows)
            if (row.method->slot == brdf::Slot::visibility && row.method->id == id) {
                row.truth = truth;
                row.cost = {{cost, cost, cost}, {1.0, 1.0, 1.0}, 1};
                row.error.emplace().mean = error;
            }
    };
    set("smith_corr", "a", 3.0, 0.0);
    set("hammon", "a", 2.0, 0.1);
    set("smith_uncorr", "a", 2.5, 0.2); // dearer and worse than hammon
    set("implicit", "b", 9.0, 0.9);     // alone with its truth
    const std::vector<bool> front = frontRows(table);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const std::string_view id = table.rows[i].method->id;
        const bool expected = table.rows[i].method->slot == brdf::Slot::visibility
                                  ? id == "smith_corr" || id == "hammon" || id == "implicit"
                                  : i == 0; // the one row of wholeTable that is measured
        EXPECT_EQ(front[i], expected) << id;
    }
}

TEST(ChartMethods, GoesOnWithItsOwnPartOnly)
{
    MethodChart chart = {.table = wholeTable(), .pictures = {}};
    chart.pictures.resize(chart.table.rows.size());
    chart.pictures.front() = {"cGljdHVyZQ==", ""};
    MethodChart empty = {.table = wholeTable(), .pictures = {}};
    empty.table.rows.clear();
    const std::string part = partText(chart, "inputs");
    const MethodChart read = parsePart(part, "p", "inputs", empty);
    EXPECT_EQ(partText(read, "inputs"), part);
    EXPECT_EQ(read.pictures.front().drawn, "cGljdHVyZQ==");
    EXPECT_THROW(parsePart(part, "p", "other inputs", empty), Error);
}

} // namespace
} // namespace torrance
