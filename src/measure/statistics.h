// Numbers that stand for many.
#pragma once

#include <span>

namespace torrance {

/// Arithmetic mean, summed pairwise in a fixed order. 0 for none.
double mean(std::span<const float> values);

/// The smallest value that at least the fraction `rank` of all values do not exceed (nearest rank), rank in (0, 1].
/// 0 for none.
double percentile(std::span<const float> values, double rank);

} // namespace torrance
