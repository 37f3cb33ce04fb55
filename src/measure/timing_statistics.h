// What repeated timings say: medians and how sure they are, whatever the distribution of the noise.
#pragma once

#include <cstddef>
#include <span>

namespace torrance {

inline constexpr double kTimingConfidence = 0.95;

/// A median and the interval that holds the true one with at least the confidence asked for.
struct Estimate
{
    double median = 0.0;
    double low = 0.0;  // -infinity and
    double high = 0.0; // infinity where there are too few values to say
    std::size_t count = 0;

    /// Of the interval, against the median.
    double relativeWidth() const { return (high - low) / median; }
};

/// The middle value, or the mean of the two middle ones. There is at least one.
double median(std::span<const double> values);

/// The rank k of n sorted values, from 1, such that the k-th from below and the k-th from above enclose the median of
/// their distribution with at least this confidence, and as closely as that allows: values below the true median are
/// counted by a binomial distribution of probability 1/2, whatever they are (David and Nagaraja, Order Statistics, 3rd
/// edition, section 7.1). 0 where n is too small.
std::size_t medianRank(std::size_t n, double confidence);

/// Of independent values of one distribution. There is at least one.
Estimate estimateMedian(std::span<const double> values, double confidence = kTimingConfidence);

/// How many times `base` is `other`: the median of the ratios other[i] / base[i] of values that were taken at one time,
/// so that what disturbs both cancels. As many of each, at least one, above 0.
Estimate estimatePairedRatio(std::span<const double> base, std::span<const double> other);

/// The same for medians that were taken apart: the interval holds the true ratio wherever theirs hold theirs. Above 0.
Estimate ratioOf(const Estimate& base, const Estimate& other);

} // namespace torrance
