// A mean with its own uncertainty, out of independent repetitions.
#pragma once

#include "math/vector.h"

#include <array>
#include <cmath>

namespace torrance {

/// Independent randomisations of one even sequence: points of one sequence are no independent samples, and their spread
/// says nothing about their mean's error; that of the means of repetitions does (Owen, Monte Carlo theory, methods and
/// examples, 2013, chapter 17).
inline constexpr int kReplicates = 16;

/// A mean of kReplicates normal numbers lies within this many estimated standard errors of the truth in 95 % of all
/// cases: the 0.975 quantile of Student's t with 15 degrees of freedom.
inline constexpr double kStudent95 = 2.1314495455597742;

struct Replicates
{
    std::array<dvec3, kReplicates> values = {}; // one estimate each

    dvec3 mean() const
    {
        dvec3 sum(0.0);
        for (const dvec3& value : values)
            sum += value;
        return sum / double(kReplicates);
    }

    /// Of the mean, per channel; unbiased.
    dvec3 variance() const
    {
        const dvec3 middle = mean();
        dvec3 sum(0.0);
        for (const dvec3& value : values)
            sum += (value - middle) * (value - middle);
        return sum / double(kReplicates * (kReplicates - 1));
    }
};

/// Half the width of the 95 % interval of |c|_1, where channels err in the same direction: the most that their
/// intervals add up to.
inline double halfWidth95(const dvec3& variance)
{
    return kStudent95 * (std::sqrt(variance.r) + std::sqrt(variance.g) + std::sqrt(variance.b));
}

} // namespace torrance
