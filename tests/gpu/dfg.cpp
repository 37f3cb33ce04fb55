// The rows of slot dfg on the device against their formulas.
#include "brdf/dfg.h"
#include "brdf/albedo.h"
#include "core/data_folder.h"
#include "passes/probe_pass.h"
#include "prepare/dfg_storage.h"
#include "study/probe_check.h"
#include "test_device.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

using namespace brdf;

std::vector<ShadingPoint> grid()
{
    std::vector<ShadingPoint> rows;
    constexpr int kSide = 24;
    for (int i = 0; i < kSide * kSide; ++i) {
        const auto NoV = static_cast<float>(0.05 + 0.95 * (i % kSide) / (kSide - 1.0));
        const auto r = static_cast<float>(0.05 + 0.95 * (i / kSide) / (kSide - 1.0));
        const double z = NoV;
        ShadingPoint point = makeShadingPoint({0, 0, 1}, {std::sqrt(1 - z * z), 0, z}, {0, 0, 1}, r);
        point.NoV = z;
        rows.push_back(point);
    }
    return rows;
}

std::vector<vec3> drawn(std::string_view id, const std::vector<ShadingPoint>& rows)
{
    return probe(test::device(), test::shaders(), makeProbeTerm(*findMethod(Slot::dfg, id)), rows);
}

TEST(DfgRows, FitsPassTheChecksOfConformance)
{
    ASSERT_GE(dfgFits().size(), 3u);
    for (const Method* fit : dfgFits()) {
        const ProbeWorst worst = worstOf(test::device(), test::shaders(), dfgFitCheck(*fit));
        EXPECT_LE(worst.ratio, 1.0) << fit->id << ": error " << worst.error << " at row " << worst.row;
    }
}

TEST(DfgRows, FitsAreTheirDoubleFormulas)
{
    const std::vector<ShadingPoint> rows = grid();
    for (const char* id : {"lazarov", "karis_mobile", "narkowicz"}) {
        const auto formula = std::get<DfgFormula>(findMethod(Slot::dfg, id)->formula);
        const std::vector<vec3> device = drawn(id, rows);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const dvec3 exact = formula(rows[i].NoV, rows[i].perceptualRoughness);
            for (int c = 0; c < 2; ++c) // sums of terms of up to 8, each rounded a few times; the lobe is judged below
                EXPECT_NEAR(device[i][c], exact[c], 4e-6) << id << ' ' << c << " at row " << i;
            EXPECT_NEAR(device[i].z, exact.z, 1e-4 * exact.z) << id << " at row " << i;
            const double dielectric = exact.x * 0.04 + exact.y;
            EXPECT_NEAR(device[i].x * 0.04 + device[i].y, dielectric, 1e-4 * dielectric + 1e-6) << id << " row " << i;
        }
    }
}

TEST(DfgRows, TablesHoldWhatTheirStorageAllows)
{
    const std::vector<ShadingPoint> rows = grid();
    const std::vector<vec3> full = drawn("table", rows), halves = drawn("table_f16", rows),
                            fractions = drawn("table_unorm16", rows);
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (int c = 0; c < 3; ++c) { // a mean of rounded nodes is off by no more than they; 2e-7 for the filter itself
            EXPECT_NEAR(halves[i][c], full[i][c], 0x1p-11f * full[i][c] + 2e-7f) << c << " at row " << i;
            EXPECT_NEAR(fractions[i][c], full[i][c], 0.5f / 65535 + 2e-7f) << c << " at row " << i;
        }
}

TEST(DfgRows, SmallTablesAreLookedUpByTheirOwnSize)
{
    const DfgTable built = readDfgTable(dataFolder() / "dfg_ggx_smith_corr.bin");
    const std::vector<ShadingPoint> rows = grid();
    for (const char* id : {"table_128", "table_32"}) {
        const DfgTable table = dfgWithNodes(built, findDfgTable(id)->width, findDfgTable(id)->height);
        const std::vector<vec3> device = drawn(id, rows);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const vec4 host =
                lookUpDfg(table, static_cast<float>(rows[i].NoV), static_cast<float>(rows[i].perceptualRoughness));
            for (int c = 0; c < 3; ++c) // coordinates of some hundred texels, rounded to 2^-24 of that
                EXPECT_NEAR(device[i][c], host[c], 1e-5) << id << ' ' << c << " at row " << i;
        }
    }
}

} // namespace
} // namespace torrance
