#include "measure/timing_statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace torrance {
namespace {

std::vector<double> sortedCopy(std::span<const double> values)
{
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    return sorted;
}

double medianOfSorted(std::span<const double> sorted)
{
    const std::size_t half = sorted.size() / 2;
    if (sorted.size() % 2 == 1 || sorted[half - 1] == sorted[half]) // the mean of two infinities is none
        return sorted[half];
    return sorted[half - 1] + 0.5 * (sorted[half] - sorted[half - 1]);
}

// Of i among n, where each is there with probability 1/2. By logarithms: 2^-n underflows from n = 1075 on.
double binomialProbability(std::size_t n, std::size_t i)
{
    const auto logFactorial = [](std::size_t m) { return std::lgamma(static_cast<double>(m) + 1.0); };
    return std::exp(logFactorial(n) - logFactorial(i) - logFactorial(n - i) - static_cast<double>(n) * std::log(2.0));
}

} // namespace

double median(std::span<const double> values)
{
    assert(!values.empty());
    return medianOfSorted(sortedCopy(values));
}

std::size_t medianRank(std::size_t n, double confidence)
{
    const double mostOnASide = 0.5 * (1.0 - confidence);
    double below = 0.0; // the probability that at most `rank` values lie below the median
    std::size_t rank = 0;
    for (; rank < n / 2; ++rank) {
        below += binomialProbability(n, rank);
        if (below > mostOnASide)
            break;
    }
    return rank;
}

Estimate estimateMedian(std::span<const double> values, double confidence)
{
    assert(!values.empty());
    const std::vector<double> sorted = sortedCopy(values);
    const std::size_t rank = medianRank(sorted.size(), confidence);
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    return {.median = medianOfSorted(sorted),
            .low = rank == 0 ? -kUnknown : sorted[rank - 1],
            .high = rank == 0 ? kUnknown : sorted[sorted.size() - rank],
            .count = sorted.size()};
}

Estimate estimatePairedRatio(std::span<const double> base, std::span<const double> other)
{
    assert(base.size() == other.size());
    std::vector<double> ratios;
    for (std::size_t i = 0; i < base.size(); ++i)
        ratios.push_back(other[i] / base[i]);
    return estimateMedian(ratios);
}

Estimate ratioOf(const Estimate& base, const Estimate& other)
{
    return {.median = other.median / base.median,
            .low = other.low / base.high,
            .high = base.low > 0.0 ? other.high / base.low : std::numeric_limits<double>::infinity(),
            .count = std::min(base.count, other.count)};
}

} // namespace torrance
