#include "brdf/dfg.h"

#include "brdf/albedo.h"
#include "brdf/shading_point.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace torrance::brdf {

dvec3 DFG_table(double NoV, double perceptualRoughness)
{
    const AlbedoTerms terms = ggxAlbedo(NoV, perceptualRoughness);
    return {terms.scale, terms.bias, schlickDiffuseWeight(NoV)};
}

double fittedDiffuseWeight(double NoV)
{
    // Lagrange's form through the exact values; the shader has the same polynomial by its coefficients.
    constexpr int kNodes = 6;
    static const auto nodes = [] {
        std::array<dvec2, kNodes> points;
        for (int i = 0; i < kNodes; ++i) {
            const double x = 0.5 + 0.5 * std::cos(kPi * (i + 0.5) / kNodes);
            points[static_cast<std::size_t>(i)] = {x, schlickDiffuseWeight(x)};
        }
        return points;
    }();
    double sum = 0;
    for (const dvec2& node : nodes) {
        double basis = 1;
        for (const dvec2& other : nodes)
            if (other.x != node.x)
                basis *= (NoV - other.x) / (node.x - other.x);
        sum += node.y * basis;
    }
    return sum;
}

dvec3 DFG_lazarov(double NoV, double perceptualRoughness)
{
    const double alpha = std::max(perceptualRoughness * perceptualRoughness, kMinAlpha);
    const double power = 2.0 / (alpha * alpha) - 2.0;
    const double gloss = std::clamp(std::log(std::max(power, 1.0)) / std::log(8192.0), 0.0, 1.0);
    // The talk's numbers before their scaling to a reflectance of 0.04: a highlight of 0.015 + 0.0275 gloss, of which
    // 0.04 (0.75 + 0.25 gloss) belong to the reflectance.
    const double grazing = gloss * std::min(0.475 * gloss, std::exp2(-9.28 * NoV));
    const double white = 0.75 + 0.25 * gloss;
    const double black = (grazing + 0.015 + 0.0175 * gloss - 0.03) / 0.96;
    return {white - black, black, fittedDiffuseWeight(NoV)};
}

dvec3 DFG_karis_mobile(double NoV, double perceptualRoughness)
{
    const double g = 1.0 - perceptualRoughness;
    const double a004 = g * std::min(g * g, std::exp2(-9.28 * NoV)) + 0.015 + 0.0275 * g;
    return {0.468 + 0.572 * g - 1.04 * a004, 1.04 * a004 - 0.018 - 0.022 * g, fittedDiffuseWeight(NoV)};
}

dvec3 DFG_narkowicz(double NoV, double perceptualRoughness)
{
    const double x = 1.0 - std::sqrt(perceptualRoughness);
    const double y = NoV;
    const double b = std::min(-0.1688 * x + 1.895 * x * x, 0.9903 - 4.853 * y + 8.404 * y * y - 5.069 * y * y * y);
    const double d =
        0.6045 + 1.699 * x - 0.5228 * y - 3.603 * x * x + 1.404 * x * y + 0.1939 * y * y + 2.661 * x * x * x;
    const double bias = std::clamp(b, 0.0, 1.0);
    return {std::clamp(d, 0.0, 1.0) - bias, bias, fittedDiffuseWeight(NoV)};
}

double lobeAlbedo(double NoV, double perceptualRoughness)
{
    thread_local double lastNoV = -1, lastRoughness = -1, E = 1;
    if (NoV != lastNoV || perceptualRoughness != lastRoughness) {
        E = ggxAlbedo(NoV, perceptualRoughness).albedo();
        lastNoV = NoV;
        lastRoughness = perceptualRoughness;
    }
    return E;
}

std::span<const DfgStorage> allDfgTables()
{
    static constexpr DfgStorage kTables[] = {
        {"table", 320, 160, DfgFormat::float32},         {"table_f16", 320, 160, DfgFormat::float16},
        {"table_unorm16", 320, 160, DfgFormat::unorm16}, {"table_128", 128, 64, DfgFormat::float32},
        {"table_32", 32, 32, DfgFormat::float32},
    };
    return kTables;
}

const DfgStorage* findDfgTable(std::string_view id)
{
    for (const DfgStorage& table : allDfgTables())
        if (table.id == id)
            return &table;
    return nullptr;
}

} // namespace torrance::brdf
