// How many directions each compared pixel gets, so that the truths' noise stays below what the comparison can bear.
#pragma once

#include <span>
#include <vector>

namespace torrance {

/// What a first look at a pixel says.
struct PixelSpread
{
    double norm = 0.0;     // |c|_1
    double variance = 0.0; // of |c|_1, times the directions it was estimated from: that of one direction
};

/// All pixels together get no more directions than this: minutes of a processor, not hours.
inline constexpr double kMostDirectionsInAll = 1 << 26;

/// The fewest directions with which the 95 % half intervals of |c|_1 add up to `noise` times the sum of |c|_1. Noise
/// falls with the root of the directions n_i, so that the least sum of n_i under a bound on the sum of s_i / sqrt(n_i)
/// has n_i in proportion to s_i^(2/3) (Lagrange). Between `least` and what kMostDirectionsInAll leaves, and whole
/// multiples of `step`. noise > 0.
std::vector<int> directionsFor(std::span<const PixelSpread> pixels, double noise, int least, int step);

} // namespace torrance
