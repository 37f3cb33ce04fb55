#include "study/error_numbers.h"

#include "measure/image_metrics.h"
#include "measure/quantile_ranks.h"
#include "measure/student.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace torrance {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

template <typename Unit>
RatioEstimate ratioOf(std::span<const PixelStratum> strata, std::span<const PixelError> errors, const Unit& unit)
{
    std::vector<RatioStratum> units;
    auto error = errors.begin();
    for (const PixelStratum& stratum : strata) {
        RatioStratum& next = units.emplace_back();
        next.population = static_cast<double>(stratum.population);
        for (std::size_t i = 0; i < stratum.drawn.size(); ++i)
            next.units.push_back(unit(*error++));
    }
    return estimateRatio(units);
}

Bounded meanOf(std::span<const PixelStratum> strata, std::span<const PixelError> errors)
{
    const RatioEstimate above = ratioOf(strata, errors, [](const PixelError& e) { return e.unitAbove(); });
    const RatioEstimate below = ratioOf(strata, errors, [](const PixelError& e) { return e.unitBelow(); });
    if (!std::isfinite(above.ratio))
        return {above.ratio, 0.0, kUnbounded};
    Bounded mean;
    mean.value = std::sqrt(above.ratio * std::max(below.ratio, 0.0)); // as PixelError::middle
    mean.low = std::max(0.0, below.ratio - student95(below.degrees) * below.standardError);
    mean.high = above.ratio;
    if (above.ratio > 0.0)
        mean.high *= std::exp(student95(above.degrees) * above.standardError / above.ratio);
    return mean;
}

Bounded percentileOf(std::size_t population, std::span<const Bounded> errors, double rank)
{
    std::vector<double> values, lows, highs;
    for (const Bounded& error : errors) {
        values.push_back(error.value);
        lows.push_back(error.low);
        highs.push_back(error.high);
    }
    for (std::vector<double>* list : {&values, &lows, &highs})
        std::ranges::sort(*list);
    const QuantileRanks ranks = quantileRanks(population, errors.size(), rank);
    Bounded result;
    result.value = values[nearestRank(values.size(), rank) - 1];
    result.low = ranks.low ? lows[*ranks.low - 1] : 0.0;
    result.high = ranks.high ? highs[*ranks.high - 1] : kUnbounded;
    return result;
}

} // namespace

double meanNormOf(std::span<const PixelStratum> strata, std::span<const PixelError> errors)
{
    double sum = 0.0, pixels = 0.0;
    auto error = errors.begin();
    for (const PixelStratum& stratum : strata) {
        for (std::size_t i = 0; i < stratum.drawn.size(); ++i)
            sum += double(stratum.population) / double(stratum.drawn.size()) * (error++)->norm;
        pixels += double(stratum.population);
    }
    return pixels > 0.0 ? sum / pixels : 0.0;
}

ErrorNumbers errorNumbers(std::span<const PixelStratum> strata, std::span<const PixelError> errors, double meanNorm)
{
    std::size_t population = 0;
    for (const PixelStratum& stratum : strata)
        population += stratum.population;
    if (errors.empty())
        return {};
    std::vector<Bounded> relative;
    for (const PixelError& error : errors)
        relative.push_back(relativeError(error, kPixelFloor * meanNorm));
    return {meanOf(strata, errors), percentileOf(population, relative, 0.5), percentileOf(population, relative, 0.99)};
}

std::string percentText(double share)
{
    return std::isfinite(share) ? fmt::format("{:.3g} %", 100.0 * share) : "unbounded";
}

std::string boundedText(const Bounded& number)
{
    return percentText(number.value) + " (" + percentText(number.low) + " to " + percentText(number.high) + ")";
}

} // namespace torrance
