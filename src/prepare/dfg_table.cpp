#include "prepare/dfg_table.h"

#include "core/atomic_write.h"
#include "core/content_hash.h"
#include "core/error.h"
#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>

namespace torrance {
namespace {

constexpr double kRootPart = 0.78;
constexpr double kPowerPart = 1.0 - kRootPart;

struct Header
{
    std::array<char, 8> magic;
    std::uint32_t width;
    std::uint32_t height;
    ContentHash hash; // of the texels
};
static_assert(sizeof(Header) == 32);
constexpr std::array<char, 8> kMagic = {'T', 'o', 'r', 'r', 'D', 'F', 'G', '1'};
constexpr std::uint32_t kMaxSize = 4096; // either side; more is a damaged file

/// Half of the error that linear interpolation makes in the middle of the cells beside node i, their mean, given the
/// function at nodes and half nodes (every second entry is a node).
dvec3 halfErrorBeside(const std::vector<dvec3>& samples, std::size_t i)
{
    dvec3 error(0.0);
    int cells = 0;
    for (const int side : {-1, 1}) {
        const auto far = static_cast<std::ptrdiff_t>(i) + 2 * side;
        if (far < 0 || far >= static_cast<std::ptrdiff_t>(samples.size()))
            continue;
        const auto f = static_cast<std::size_t>(far);
        error += 0.5 * (samples[i] + samples[f]) - samples[(i + f) / 2];
        ++cells;
    }
    return cells > 0 ? 0.5 / cells * error : dvec3(0.0);
}

/// A formula on the grid of half steps: columns at nodes, and between them along either axis.
struct HalfGrid
{
    int width, height;                           // of the nodes
    std::vector<std::vector<dvec3>> alongX;      // per row of nodes, 2 width - 1 samples
    std::vector<std::vector<dvec3>> betweenRows; // per gap of rows, width samples
};

HalfGrid sampleHalfGrid(brdf::DfgFormula formula, int width, int height)
{
    const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
    HalfGrid grid{width, height, {}, {}};
    grid.alongX.assign(h, std::vector<dvec3>(2 * w - 1));
    grid.betweenRows.assign(h - 1, std::vector<dvec3>(w));
    parallelFor(2 * h - 1, 1, [&](std::size_t halfRow) {
        const double y = 0.5 * static_cast<double>(halfRow) / (height - 1);
        std::vector<dvec3>& row = halfRow % 2 == 0 ? grid.alongX[halfRow / 2] : grid.betweenRows[halfRow / 2];
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i] = formula(dfgNoV(static_cast<double>(i) / static_cast<double>(row.size() - 1)), dfgRoughness(y));
    });
    return grid;
}

/// The node's value, shifted against the error of both axes.
dvec3 balancedNode(const HalfGrid& grid, std::size_t column, std::size_t row)
{
    std::vector<dvec3> alongY(2 * static_cast<std::size_t>(grid.height) - 1);
    for (std::size_t j = 0; j < alongY.size(); ++j)
        alongY[j] = j % 2 == 0 ? grid.alongX[j / 2][2 * column] : grid.betweenRows[j / 2][column];
    return grid.alongX[row][2 * column] - halfErrorBeside(grid.alongX[row], 2 * column) -
           halfErrorBeside(alongY, 2 * row);
}

} // namespace

dvec2 dfgCoordinates(double NoV, double perceptualRoughness)
{
    return {kRootPart * std::sqrt(NoV) + kPowerPart * NoV * NoV * NoV * NoV, std::sqrt(perceptualRoughness)};
}

double dfgNoV(double x)
{
    // Bisection for t = sqrt(NoV) of the rising polynomial kRootPart t + kPowerPart t^8 = x; 60 halvings exhaust a
    // double.
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double t = 0.5 * (low + high);
        (kRootPart * t + kPowerPart * std::pow(t, 8) < x ? low : high) = t;
    }
    return high * high;
}

double dfgRoughness(double y)
{
    return y * y;
}

DfgTable makeDfgTable(brdf::DfgFormula formula, int width, int height)
{
    const HalfGrid grid = sampleHalfGrid(formula, width, height);
    DfgTable table{width, height, {}};
    for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row)
        for (std::size_t column = 0; column < static_cast<std::size_t>(width); ++column) {
            const dvec3 terms = balancedNode(grid, column, row);
            for (const double value : {terms.x, terms.y, terms.z, terms.x + terms.y})
                table.texels.push_back(static_cast<float>(value));
        }
    return table;
}

vec4 lookUpDfg(const DfgTable& table, float NoV, float perceptualRoughness)
{
    const float n2 = NoV * NoV;
    const float x = (static_cast<float>(kRootPart) * std::sqrt(NoV) + static_cast<float>(kPowerPart) * n2 * n2) *
                    static_cast<float>(table.width - 1);
    const float y = std::sqrt(perceptualRoughness) * static_cast<float>(table.height - 1);
    const int column = std::min(static_cast<int>(x), table.width - 2),
              row = std::min(static_cast<int>(y), table.height - 2);
    const float fx = x - static_cast<float>(column), fy = y - static_cast<float>(row);
    const auto texel = [&](int i, int j) {
        const float* t =
            table.texels.data() +
            4 * (static_cast<std::size_t>(j) * static_cast<std::size_t>(table.width) + static_cast<std::size_t>(i));
        return vec4(t[0], t[1], t[2], t[3]);
    };
    const vec4 upper = texel(column, row) * (1.0f - fx) + texel(column + 1, row) * fx;
    const vec4 lower = texel(column, row + 1) * (1.0f - fx) + texel(column + 1, row + 1) * fx;
    return upper * (1.0f - fy) + lower * fy;
}

void writeDfgTable(const std::filesystem::path& path, const DfgTable& table)
{
    const auto texels = std::as_bytes(std::span(table.texels));
    const Header header{kMagic, static_cast<std::uint32_t>(table.width), static_cast<std::uint32_t>(table.height),
                        hashBytes(texels)};
    std::vector<std::byte> bytes(sizeof header + texels.size());
    std::memcpy(bytes.data(), &header, sizeof header);
    std::memcpy(bytes.data() + sizeof header, texels.data(), texels.size());
    writeFile(path, std::span<const std::byte>(bytes));
}

DfgTable readDfgTable(const std::filesystem::path& path)
{
    const auto refuse = [&](std::string_view problem) {
        return inputError(path.string(), "DFG table", problem, "build or install Torrance anew");
    };
    std::ifstream file(path, std::ios::binary);
    Header header{};
    if (!file)
        throw refuse("cannot be opened");
    if (!file.read(reinterpret_cast<char*>(&header), sizeof header) || header.magic != kMagic || header.width < 2 ||
        header.height < 2 || header.width > kMaxSize || header.height > kMaxSize)
        throw refuse("is not a table of this version");
    DfgTable table{static_cast<int>(header.width), static_cast<int>(header.height), {}};
    table.texels.resize(std::size_t{4} * header.width * header.height);
    file.read(reinterpret_cast<char*>(table.texels.data()),
              static_cast<std::streamsize>(table.texels.size() * sizeof(float)));
    if (!file || file.peek() != std::ifstream::traits_type::eof() ||
        hashBytes(std::as_bytes(std::span(table.texels))) != header.hash)
        throw refuse("is damaged");
    return table;
}

} // namespace torrance
