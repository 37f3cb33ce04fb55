// Which sorted values of a sample enclose a quantile of the population that it was drawn from.
#pragma once

#include <cstddef>
#include <optional>

namespace torrance {

/// Ranks from 1 among the sorted sample; none where the sample is too small to bound that side.
struct QuantileRanks
{
    std::optional<std::size_t> low, high;
};

/// A sample of `drawn` out of `population` units without replacement encloses the smallest value that at least the
/// fraction `rank` of the units do not exceed: the probability that it lies below value `low`, or above value `high`,
/// is at most 0.025 each, whatever the values are. How many of the r = ceil(rank * population) lowest units were drawn
/// is hypergeometric (Wilks, Mathematical Statistics, 1962, section 11.4, of finite populations; the binomial of David
/// and Nagaraja, Order Statistics, section 7.1, is its limit); where all were drawn both ranks are r.
/// 1 <= drawn <= population, 0 < rank <= 1.
QuantileRanks quantileRanks(std::size_t population, std::size_t drawn, double rank);

/// The rank of the quantile itself in n sorted values: ceil(rank * n), at least 1.
std::size_t nearestRank(std::size_t n, double rank);

} // namespace torrance
