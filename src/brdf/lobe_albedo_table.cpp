#include "brdf/lobe_albedo_table.h"

#include "brdf/albedo.h"
#include "brdf/lobe_albedo.h"
#include "brdf/shading_point.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace torrance::brdf {
namespace {

constexpr int kCosines = 160;
constexpr int kRoughnesses = 96;
constexpr int kPoints = 6; // of the polynomial in either coordinate
static_assert(kCosines >= kPoints && kRoughnesses >= kPoints);

// Of the roughness: below it kMinAlpha rules, and E is what it is there.
const double kLeastRoot = std::sqrt(std::sqrt(kMinAlpha));

double alphaOf(double perceptualRoughness)
{
    return std::max(perceptualRoughness * perceptualRoughness, kMinAlpha);
}

// E turns within NoV ~ alpha, whatever the decade, and is not smooth at 0: this goes as the root below alpha and as the
// logarithm above, from 0 to 1.
double cosineCoordinate(double NoV, double perceptualRoughness)
{
    const double alpha = alphaOf(perceptualRoughness);
    return std::asinh(std::sqrt(NoV / alpha)) / std::asinh(std::sqrt(1.0 / alpha));
}

double cosineAt(double x, double perceptualRoughness)
{
    const double alpha = alphaOf(perceptualRoughness);
    const double root = std::sinh(x * std::asinh(std::sqrt(1.0 / alpha)));
    return std::min(1.0, alpha * root * root);
}

double roughnessCoordinate(double perceptualRoughness)
{
    return std::clamp((std::sqrt(perceptualRoughness) - kLeastRoot) / (1.0 - kLeastRoot), 0.0, 1.0);
}

double roughnessAt(double y)
{
    const double root = kLeastRoot + (1.0 - kLeastRoot) * y;
    return root * root;
}

/// The polynomial through kPoints neighbours of `count` nodes spread evenly over [0, 1], by Lagrange.
struct Stencil
{
    int first;
    std::array<double, kPoints> weights;
};

Stencil stencilAt(double x, int count)
{
    constexpr std::array<double, kPoints> kDenominators = {-120, 24, -12, 12, -24, 120}; // product of (i - j), j != i
    const double position = x * (count - 1);
    Stencil stencil;
    stencil.first = std::clamp(static_cast<int>(position) - kPoints / 2 + 1, 0, count - kPoints);
    for (int i = 0; i < kPoints; ++i) {
        double product = 1.0;
        for (int j = 0; j < kPoints; ++j)
            if (j != i)
                product *= position - stencil.first - j;
        stencil.weights[i] = product / kDenominators[i];
    }
    return stencil;
}

/// 0 until it is computed, for every surface returns some light. Threads that meet here compute the same number.
using Node = std::atomic<double>;

template <typename Function>
double valueOf(Node& node, const Function& compute)
{
    double value = node.load(std::memory_order_relaxed);
    if (value == 0.0) {
        value = compute();
        node.store(value, std::memory_order_relaxed);
    }
    return value;
}

AlbedoTerms termsOfNode(int column, int row)
{
    const double r = roughnessAt(row / (kRoughnesses - 1.0));
    return ggxAlbedo(cosineAt(column / (kCosines - 1.0), r), r);
}

double albedoNode(int column, int row)
{
    static std::array<Node, kCosines * kRoughnesses> nodes;
    return valueOf(nodes[row * kCosines + column], [&] { return termsOfNode(column, row).albedo(); });
}

double biasNode(int column, int row)
{
    static std::array<Node, kCosines * kRoughnesses> nodes;
    return valueOf(nodes[row * kCosines + column], [&] { return termsOfNode(column, row).bias; });
}

double averageNode(int row)
{
    static std::array<Node, kRoughnesses> nodes;
    return valueOf(nodes[row], [&] { return averageLobeAlbedo(roughnessAt(row / (kRoughnesses - 1.0))); });
}

} // namespace

namespace {

/// The nodes about a place, with the weights of both coordinates.
struct Neighbours
{
    Stencil columns, rows;

    Neighbours(double NoV, double perceptualRoughness)
        : columns(stencilAt(cosineCoordinate(NoV, perceptualRoughness), kCosines)),
          rows(stencilAt(roughnessCoordinate(perceptualRoughness), kRoughnesses))
    {
    }

    double interpolate(double (*node)(int column, int row)) const
    {
        double sum = 0.0;
        for (int j = 0; j < kPoints; ++j)
            for (int i = 0; i < kPoints; ++i)
                sum += rows.weights[j] * columns.weights[i] * node(columns.first + i, rows.first + j);
        return sum;
    }
};

struct Kept
{
    double NoV = -1.0, perceptualRoughness = -1.0;
    AlbedoTerms terms;
};

} // namespace

double lobeAlbedoFromTable(double NoV, double perceptualRoughness)
{
    return Neighbours(NoV, perceptualRoughness).interpolate(albedoNode);
}

AlbedoTerms lobeTermsFromTable(double NoV, double perceptualRoughness)
{
    thread_local Kept kept;
    if (kept.NoV != NoV || kept.perceptualRoughness != perceptualRoughness) {
        const Neighbours neighbours(NoV, perceptualRoughness);
        const double bias = neighbours.interpolate(biasNode);
        kept = {NoV, perceptualRoughness, {neighbours.interpolate(albedoNode) - bias, bias}};
    }
    return kept.terms;
}

double averageLobeAlbedoFromTable(double perceptualRoughness)
{
    const Stencil rows = stencilAt(roughnessCoordinate(perceptualRoughness), kRoughnesses);
    double sum = 0.0;
    for (int j = 0; j < kPoints; ++j)
        sum += rows.weights[j] * averageNode(rows.first + j);
    return sum;
}

} // namespace torrance::brdf
