// A ratio of two sums over a whole population, from a stratified random sample of units that are measured with noise.
#pragma once

#include <span>
#include <vector>

namespace torrance {

/// A sampled unit: unbiased measurements of its two numbers, and how they scatter about the truth.
struct RatioUnit
{
    double numerator = 0.0;
    double denominator = 0.0;
    double numeratorVariance = 0.0; // of the measurement, not of the population
    double denominatorVariance = 0.0;
    double covariance = 0.0;
};

struct RatioStratum
{
    double population = 0.0;      // units in it, sampled or not
    std::vector<RatioUnit> units; // a simple random sample without replacement: all of them, or two at least
};

struct RatioEstimate
{
    double ratio = 0.0;
    double standardError = 0.0;
    double degrees = 0.0; // of freedom, of the standard error
};

/// How many repetitions each unit's variances were estimated from, less one.
inline constexpr double kNoiseDegrees = 15.0;

/// The combined ratio estimate (Cochran, Sampling Techniques, 3rd edition, 1977, eq. 6.48) with the linearised variance
/// (eq. 6.51) of residuals e = numerator - ratio * denominator, of a sample in two stages: the population's part counts
/// (1 - n/N), what the measurements add does not (eq. 11.24: sum of N^2 (1 - f) s_e^2 / n + N/n sum of the noise's
/// variances). Degrees of freedom are Satterthwaite's (Cochran eq. 5.16), which fall where a few units carry most of
/// the variance, as in pictures whose error sits in a few highlights. 0 over 0 is 0.
RatioEstimate estimateRatio(std::span<const RatioStratum> strata);

} // namespace torrance
