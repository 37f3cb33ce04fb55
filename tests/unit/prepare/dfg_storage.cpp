#include "prepare/dfg_storage.h"

#include "brdf/albedo.h"
#include "math/half.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

namespace torrance {
namespace {

const DfgTable& builtTable()
{
    static const DfgTable table =
        readDfgTable(std::filesystem::path(TORRANCE_BINARY_DIR) / "share/torrance/dfg_ggx_smith_corr.bin");
    return table;
}

std::vector<std::uint16_t> codesOf(const std::vector<std::byte>& bytes)
{
    std::vector<std::uint16_t> codes(bytes.size() / 2);
    std::memcpy(codes.data(), bytes.data(), bytes.size());
    return codes;
}

// A normal half: 1.mantissa times 2^(exponent - 15).
double fromHalf(std::uint16_t half)
{
    const int exponent = half >> 10, mantissa = half & 0x3ff;
    return exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25);
}

TEST(DfgStorage, TheFirstRowIsTheBuiltTable)
{
    const brdf::DfgStorage& table = *brdf::findDfgTable("table");
    EXPECT_EQ(table.width, kDfgWidth);
    EXPECT_EQ(table.height, kDfgHeight);
    EXPECT_EQ(dfgWithNodes(builtTable(), table.width, table.height).texels, builtTable().texels);
}

TEST(DfgStorage, HalvesAreWithinTheirRounding)
{
    const auto codes = codesOf(packDfg(builtTable(), brdf::DfgFormat::float16));
    ASSERT_EQ(codes.size(), builtTable().texels.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const double value = builtTable().texels[i];
        ASSERT_LE(std::abs(fromHalf(codes[i]) - value), std::max(0x1p-11 * value, 0x1p-25)) << i;
    }
}

TEST(DfgStorage, FractionsAreWithinHalfAStep)
{
    const auto codes = codesOf(packDfg(builtTable(), brdf::DfgFormat::unorm16));
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const double value = builtTable().texels[i];
        ASSERT_LE(std::abs(codes[i] / 65535.0 - std::clamp(value, 0.0, 1.0)), 0.501 / 65535) << i;
        if (value < 0 || value > 1) {
            const auto column = static_cast<double>(i / 4 % kDfgWidth);
            ASSERT_LT(dfgNoV(column / (kDfgWidth - 1)), 1e-3) << value << ": outside of the rows' domain only";
        }
    }
}

double worstAlbedoError(const DfgTable& table)
{
    double worst = 0;
    for (double r = 0.25; r < 1; r += 0.0173)
        for (double NoV = 0.1; NoV < 1; NoV += 0.0191) {
            const double got = lookUpDfg(table, static_cast<float>(NoV), static_cast<float>(r)).w;
            worst = std::max(worst,
                             std::abs(got - brdf::ggxAlbedo(static_cast<float>(NoV), static_cast<float>(r)).albedo()));
        }
    return worst;
}

// Linear interpolation misses a curved function by the square of the step: half the nodes, four times the error. The
// steps are those of 16, 32 and 64 nodes either way.
TEST(DfgStorage, FewerNodesMissByTheSquareOfTheStep)
{
    const double errors[] = {worstAlbedoError(dfgWithNodes(builtTable(), 16, 16)),
                             worstAlbedoError(dfgWithNodes(builtTable(), 32, 32)),
                             worstAlbedoError(dfgWithNodes(builtTable(), 64, 64))};
    const double ratios[] = {(31.0 / 15) * (31.0 / 15), (63.0 / 31) * (63.0 / 31)};
    for (int i = 0; i < 2; ++i)
        EXPECT_NEAR(errors[i] / errors[i + 1] / ratios[i], 1.0, 0.35)
            << "where the worst place lies in its cell differs";
}

} // namespace
} // namespace torrance
