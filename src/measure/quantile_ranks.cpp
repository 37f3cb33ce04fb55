#include "measure/quantile_ranks.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace torrance {
namespace {

constexpr double kTail = 0.025;

double logChoose(double n, double k)
{
    return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
}

/// P(exactly k of `marked` units out of `population` are among `drawn`).
double hypergeometric(std::size_t population, std::size_t marked, std::size_t drawn, std::size_t k)
{
    if (k > marked || k > drawn || drawn - k > population - marked)
        return 0.0;
    const auto P = double(population), m = double(marked), n = double(drawn), x = double(k);
    return std::exp(logChoose(m, x) + logChoose(P - m, n - x) - logChoose(P, n));
}

} // namespace

std::size_t nearestRank(std::size_t n, double rank)
{
    // 0.99 * 100 is a little above 99 in binary: what is whole up to rounding is whole.
    const double exact = rank * double(n), whole = std::round(exact);
    constexpr double kRounding = 1e-12;
    const double up = std::abs(exact - whole) <= kRounding * exact ? whole : std::ceil(exact);
    return std::clamp<std::size_t>(static_cast<std::size_t>(up), 1, n);
}

QuantileRanks quantileRanks(std::size_t population, std::size_t drawn, double rank)
{
    assert(drawn >= 1 && drawn <= population && rank > 0.0 && rank <= 1.0);
    const std::size_t lowest = nearestRank(population, rank);
    QuantileRanks ranks;
    double below = 0.0; // P(fewer than k of the lowest were drawn): then value k lies above the quantile
    for (std::size_t k = 1; k <= drawn; ++k) {
        below += hypergeometric(population, lowest, drawn, k - 1);
        if (below > kTail)
            break;
        ranks.low = k;
    }
    double atMost = 0.0; // P(fewer than k of those before the quantile were drawn): then value k does not lie below it
    for (std::size_t k = 1; k <= drawn && !ranks.high; ++k) {
        atMost += hypergeometric(population, lowest - 1, drawn, k - 1);
        if (atMost >= 1.0 - kTail)
            ranks.high = k;
    }
    return ranks;
}

} // namespace torrance
