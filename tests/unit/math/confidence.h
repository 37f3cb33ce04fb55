// When an estimate contradicts the truth. Seeds are fixed; a right program fails a family of comparisons for one seed
// in 1 / kFamilyLevel.
#pragma once

#include "math/replicates.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::test {

inline constexpr double kFamilyLevel = 1e-4;

/// Probability that |t| is at least this under Student's t with 15 degrees of freedom: Abramowitz & Stegun
/// 1964, 26.7.4.
inline double studentTail15(double t)
{
    const double theta = std::atan(std::abs(t) / std::sqrt(15.0)), c = std::cos(theta);
    double term = c, sum = c;
    for (int i = 2; i <= 12; i += 2)
        sum += term *= c * c * i / (i + 1.0);
    return 1.0 - 2.0 / kPi * (theta + std::sin(theta) * sum);
}

/// How unlikely the replicates' mean is where `exact` is the truth; `slack` is what the truth itself may be off by. The
/// least of the three channels.
inline double likelihood(const dvec3& mean, const dvec3& variance, const dvec3& exact, double slack)
{
    double least = 1.0;
    for (int c = 0; c < 3; ++c) {
        const double beyond = std::max(0.0, std::abs(mean[c] - exact[c]) - slack);
        least = std::min(least, beyond == 0.0 ? 1.0 : studentTail15(beyond / std::sqrt(variance[c])));
    }
    return least;
}

/// Bonferroni: each of `comparisons` colours, three channels each, has its share of the family's level.
inline ::testing::AssertionResult agrees(const Replicates& replicates, const dvec3& exact, double slack,
                                         std::size_t comparisons)
{
    const dvec3 mean = replicates.mean(), variance = replicates.variance();
    const double p = likelihood(mean, variance, exact, slack);
    if (p >= kFamilyLevel / (3.0 * static_cast<double>(comparisons)))
        return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "(" << mean.r << ", " << mean.g << ", " << mean.b << ") +- ("
                                         << std::sqrt(variance.r) << ", " << std::sqrt(variance.g) << ", "
                                         << std::sqrt(variance.b) << ") is not (" << exact.r << ", " << exact.g << ", "
                                         << exact.b << "): p = " << p;
}

/// Estimate by estimate: what both have in common cancels.
inline Replicates difference(const Replicates& a, const Replicates& b)
{
    Replicates result;
    for (std::size_t r = 0; r < kReplicates; ++r)
        result.values[r] = a.values[r] - b.values[r];
    return result;
}

} // namespace torrance::test
