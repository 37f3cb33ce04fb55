// How a cost grows with the size of what causes it: by how much a unit, and whether by more than in proportion.
#pragma once

#include "measure/timing_statistics.h"

#include <span>
#include <string_view>
#include <vector>

namespace torrance {

struct Line
{
    double constant = 0.0;
    double slope = 0.0;
};

/// The line through points of two or more different sizes, where some may be far off: the slope is the median of the
/// slopes of all pairs, each weighed by the distance of its sizes (Jaeckel, Estimating regression coefficients by
/// minimizing the dispersion of the residuals, 1972), the constant the median of what is left.
Line fitLine(std::span<const double> sizes, std::span<const double> costs);

/// p of the cost a + b n^p that has these values at n, r n and r^2 n, whatever a and b: log_r of the ratio of the two
/// differences. -infinity where the cost does not grow from the second to the third, infinity where it grows there and
/// not before. ratio > 1.
double growthExponent(double first, double second, double third, double ratio);

enum class GrowthKind
{
    none,        // what grows cannot be told from nothing, or is less than kLeastGrowth of the cost
    linear,      // at most
    superLinear, // the exponent's interval lies above kSuperLinear
    undecided,   // it holds kSuperLinear, or there is none
};

std::string_view nameOf(GrowthKind kind);

/// Above n log n at a thousand or more, whose exponent by growthExponent with r = 4 is 1.15 there and falls; below what
/// a term of n^2 does that is three tenths of the linear one at the greatest size: 1.17.
inline constexpr double kSuperLinear = 1.15;
inline constexpr double kLeastGrowth = 0.05; // from the least to the greatest size, of the greatest cost

struct GrowthFit
{
    Estimate constant;
    Estimate slope;    // per unit of size
    Estimate exponent; // of the three greatest sizes
    GrowthKind kind = GrowthKind::undecided;
};

/// Each round holds a cost for every size, taken one soon after the other: a line and an exponent are fitted to each
/// round, and the intervals are those of their medians over the rounds. Sizes ascend, three or more; the last three are
/// in one ratio. There is at least one round.
GrowthFit fitGrowth(std::span<const double> sizes, std::span<const std::vector<double>> rounds);

} // namespace torrance
