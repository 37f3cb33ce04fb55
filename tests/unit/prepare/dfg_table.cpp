#include "prepare/dfg_table.h"

#include "brdf/albedo.h"
#include "brdf/dfg.h"
#include "brdf/integration_map.h"
#include "core/atomic_write.h"
#include "core/error.h"
#include "core/parallel.h"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <mutex>
#include <string>

namespace torrance {
namespace {

namespace fs = std::filesystem;

/// The table that the build made.
const DfgTable& builtTable()
{
    static const DfgTable table = readDfgTable(fs::path(TORRANCE_BINARY_DIR) / "share/torrance/dfg_ggx_smith_corr.bin");
    return table;
}

struct Worst
{
    double error = 0.0, NoV = 0.0, r = 0.0, f0 = 0.0;

    void take(const Worst& other)
    {
        if (!(other.error <= error)) // a NaN is the worst
            *this = other;
    }
};

/// The largest relative error of F0 * scale + bias, of E (F0 = 2) and of w (F0 = 3) at one place.
Worst errorAt(double NoV, double r)
{
    const vec4 got = lookUpDfg(builtTable(), static_cast<float>(NoV), static_cast<float>(r));
    const brdf::AlbedoTerms exact = brdf::ggxAlbedo(static_cast<float>(NoV), static_cast<float>(r));
    Worst worst;
    const auto compare = [&](double value, double truth, double f0) {
        worst.take({std::abs(value / truth - 1.0), NoV, r, f0});
    };
    for (const double f0 : {0.04, 0.1, 0.3, 1.0})
        compare(got.x * f0 + got.y, exact.scale * f0 + exact.bias, f0);
    compare(got.w, exact.albedo(), 2.0);
    compare(got.z, brdf::schlickDiffuseWeight(static_cast<float>(NoV)), 3.0);
    return worst;
}

/// Off the grid: neither step divides the table's. Half of the columns are even in NoV, half in its logarithm.
Worst worstOver(double firstR, double firstNoV, int rows, int columns)
{
    Worst worst;
    std::mutex mutex;
    parallelFor(static_cast<std::size_t>(rows), 1, [&](std::size_t j) {
        const double t = (static_cast<double>(j) + 0.37) / rows;
        const double r = firstR + (1.0 - firstR) * t * t; // denser where the lobe changes quickly
        Worst ofRow;
        for (int i = 0; i < columns; ++i) {
            const double x = (i + 0.61) / columns;
            ofRow.take(errorAt(i % 2 == 0 ? firstNoV + (1.0 - firstNoV) * x : std::pow(firstNoV, 1.0 - x), r));
        }
        const std::lock_guard lock(mutex);
        worst.take(ofRow);
    });
    return worst;
}

TEST(DfgTable, BilinearLookupIsWithinItsPromise)
{
    for (const auto& [firstR, firstNoV] : {std::pair(0.1, 1e-3), std::pair(0.05, 0.05)}) {
        const Worst worst = worstOver(firstR, firstNoV, 61, 331);
        EXPECT_LT(worst.error, 1e-4) << "NoV " << worst.NoV << " r " << worst.r << " F0 (2: E, 3: w) " << worst.f0;
    }
}

TEST(DfgTable, AHalvedTableMisses)
{
    // What makes the promise a matter of size: a quarter of the texels has four times the error.
    const DfgTable small = makeDfgTable(&brdf::DFG_table, 40, 20);
    const vec4 got = lookUpDfg(small, 0.0125f, 0.11f);
    EXPECT_GT(std::abs(got.w / brdf::ggxAlbedo(0.0125f, 0.11f).albedo() - 1.0), 1e-4);
}

// Within 1e-4 of light of radiance 1 everywhere, mirrors at grazing view included: its masking makes no thin layers.
TEST(DfgTable, OfSourceBIsWithinItsPromise)
{
    const DfgTable map = readDfgTable(fs::path(TORRANCE_BINARY_DIR) / "share/torrance/dfg_ggx_burley.bin");
    Worst worst;
    for (int j = 0; j <= 61; ++j)
        for (int i = 0; i <= 97; ++i) {
            const auto r = static_cast<float>(std::pow(j / 61.0, 2)), NoV = static_cast<float>(std::pow(i / 97.0, 2));
            const vec4 got = lookUpDfg(map, NoV, r);
            const dvec3 exact = brdf::integrationMap(NoV, r);
            for (int c = 0; c < 3; ++c)
                worst.take({std::abs(got[c] - exact[c]), NoV, r, static_cast<double>(c)});
            EXPECT_NEAR(got.w, got.x + got.y, 1e-6) << "NoV " << NoV << " r " << r;
        }
    EXPECT_LT(worst.error, 1e-4) << "NoV " << worst.NoV << " r " << worst.r << " integral " << worst.f0;
}

TEST(DfgTable, IsFiniteAndEnergyStaysBelowOneUpToItsError)
{
    const DfgTable& table = builtTable();
    ASSERT_EQ(table.texels.size(), std::size_t{4} * kDfgWidth * kDfgHeight);
    for (std::size_t i = 0; i < table.texels.size(); i += 4) {
        ASSERT_TRUE(std::isfinite(table.texels[i]) && std::isfinite(table.texels[i + 1]) &&
                    std::isfinite(table.texels[i + 2]));
        ASSERT_GT(table.texels[i + 3], 0.3f);
        ASSERT_LT(table.texels[i + 3],
                  1.02f); // next to NoV = 0 the shift against the interpolation's error exceeds one at low roughness
    }
}

TEST(DfgTable, CoordinatesInvert)
{
    for (double x = 0.0; x <= 1.0; x += 0.01) {
        EXPECT_NEAR(dfgCoordinates(dfgNoV(x), 0.0).x, x, 1e-15);
        EXPECT_NEAR(dfgCoordinates(0.0, dfgRoughness(x)).y, x, 1e-15);
    }
    EXPECT_EQ(dfgNoV(1.0), 1.0);
}

class DfgTableFile : public testing::Test
{
protected:
    fs::path path = fs::path(testing::TempDir()) /
                    ("dfg_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));

    void TearDown() override { fs::remove(path); }

    std::string bytes() const
    {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    void expectRefused() const
    {
        try {
            readDfgTable(path);
            ADD_FAILURE() << "was read";
        } catch (const Error& error) {
            EXPECT_EQ(error.exitCode, ExitCode::input);
            EXPECT_NE(std::string(error.what()).find(path.filename().string()), std::string::npos) << error.what();
        }
    }
};

TEST_F(DfgTableFile, IsReadAsWritten)
{
    writeDfgTable(path, builtTable());
    EXPECT_EQ(readDfgTable(path).texels, builtTable().texels);
}

TEST_F(DfgTableFile, DamageIsRefused)
{
    expectRefused(); // missing
    writeDfgTable(path, builtTable());
    const std::string whole = bytes();
    std::string flipped = whole;
    flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 1);
    std::string otherMagic = whole;
    otherMagic[0] = 'X';
    std::string huge = whole;
    huge[11] = 0x7f; // width
    for (const std::string& damaged : {std::string(), whole.substr(0, 20), whole.substr(0, whole.size() - 1),
                                       whole + "x", flipped, otherMagic, huge})
    {
        writeFile(path, damaged);
        expectRefused();
    }
}

TEST(DfgTable, IsTheSameEveryTime)
{
    EXPECT_EQ(makeDfgTable(&brdf::DFG_table, 16, 8).texels, makeDfgTable(&brdf::DFG_table, 16, 8).texels);
}

} // namespace
} // namespace torrance
