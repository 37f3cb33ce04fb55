#include "measure/growth_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace torrance {
namespace {

struct PairSlope
{
    double slope;
    double weight;
};

double weightedMedian(std::vector<PairSlope> slopes)
{
    std::ranges::sort(slopes, {}, &PairSlope::slope);
    double all = 0.0;
    for (const PairSlope& pair : slopes)
        all += pair.weight;
    double below = 0.0;
    for (const PairSlope& pair : slopes) {
        below += pair.weight;
        if (below >= 0.5 * all)
            return pair.slope;
    }
    return slopes.back().slope;
}

GrowthKind kindOf(const GrowthFit& fit, double range, double greatest)
{
    if (!(fit.slope.low > 0.0) || fit.slope.median * range < kLeastGrowth * greatest)
        return std::isfinite(fit.slope.low) ? GrowthKind::none : GrowthKind::undecided;
    if (fit.exponent.low > kSuperLinear)
        return GrowthKind::superLinear;
    return fit.exponent.high <= kSuperLinear ? GrowthKind::linear : GrowthKind::undecided;
}

} // namespace

Line fitLine(std::span<const double> sizes, std::span<const double> costs)
{
    assert(sizes.size() == costs.size());
    std::vector<PairSlope> slopes;
    for (std::size_t i = 0; i < sizes.size(); ++i)
        for (std::size_t j = i + 1; j < sizes.size(); ++j)
            if (const double distance = sizes[j] - sizes[i]; distance != 0.0)
                slopes.push_back({(costs[j] - costs[i]) / distance, std::abs(distance)});
    assert(!slopes.empty());
    Line line = {.constant = 0.0, .slope = weightedMedian(std::move(slopes))};
    std::vector<double> rest;
    for (std::size_t i = 0; i < sizes.size(); ++i)
        rest.push_back(costs[i] - line.slope * sizes[i]);
    line.constant = median(rest);
    return line;
}

double growthExponent(double first, double second, double third, double ratio)
{
    const double before = second - first, after = third - second;
    if (after <= 0.0)
        return -std::numeric_limits<double>::infinity();
    if (before <= 0.0)
        return std::numeric_limits<double>::infinity();
    return std::log(after / before) / std::log(ratio);
}

std::string_view nameOf(GrowthKind kind)
{
    switch (kind) {
    case GrowthKind::none:
        return "none";
    case GrowthKind::linear:
        return "at most linear";
    case GrowthKind::superLinear:
        return "super-linear";
    case GrowthKind::undecided:
        break;
    }
    return "undecided";
}

GrowthFit fitGrowth(std::span<const double> sizes, std::span<const std::vector<double>> rounds)
{
    const std::size_t n = sizes.size();
    assert(n >= 3 && !rounds.empty());
    const double ratio = sizes[n - 1] / sizes[n - 2];
    assert(std::abs(sizes[n - 2] / sizes[n - 3] - ratio) < 1e-9 * ratio);
    std::vector<double> constants, slopes, exponents, greatest;
    for (const std::vector<double>& costs : rounds) {
        const Line line = fitLine(sizes, costs);
        constants.push_back(line.constant);
        slopes.push_back(line.slope);
        exponents.push_back(growthExponent(costs[n - 3], costs[n - 2], costs[n - 1], ratio));
        greatest.push_back(costs[n - 1]);
    }
    GrowthFit fit = {.constant = estimateMedian(constants),
                     .slope = estimateMedian(slopes),
                     .exponent = estimateMedian(exponents),
                     .kind = GrowthKind::undecided};
    fit.kind = kindOf(fit, sizes[n - 1] - sizes[0], median(greatest));
    return fit;
}

} // namespace torrance
