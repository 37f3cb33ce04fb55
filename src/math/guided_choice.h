// One of many intervals, by its length, in a time that does not grow with their number: Chen & Asau, On Generating
// Random Variates from an Empirical Distribution, 1974. A guide says for each of as many even steps where a search
// begins.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace torrance {

struct IntervalChoice
{
    std::size_t index = 0;
    double rest = 0.0; // where in the chosen interval, [0, 1]
};

/// `sums` are running sums of lengths, none negative; the guide has as many entries.
inline void makeGuide(std::span<const double> sums, std::span<std::uint32_t> guide)
{
    const double step = sums.back() / static_cast<double>(guide.size());
    std::size_t at = 0;
    for (std::size_t i = 0; i < guide.size(); ++i) {
        while (at < sums.size() && sums[at] <= step * static_cast<double>(i))
            ++at;
        guide[i] = static_cast<std::uint32_t>(at);
    }
}

/// `at` is the first interval whose sum is beyond the target, or their number: u * sum rounded up to the sum.
inline IntervalChoice intervalAt(std::span<const double> sums, std::size_t at, double target)
{
    if (at == sums.size())
        at = static_cast<std::size_t>(std::lower_bound(sums.begin(), sums.end(), sums.back()) - sums.begin());
    const double before = at == 0 ? 0.0 : sums[at - 1];
    return {at, std::clamp((target - before) / (sums[at] - before), 0.0, 1.0)};
}

/// The interval in which the fraction u (in [0, 1]) of the last sum lies, which is above 0; never one without length.
inline IntervalChoice choose(std::span<const double> sums, double u)
{
    const double target = u * sums.back();
    const auto found = std::upper_bound(sums.begin(), sums.end(), target);
    return intervalAt(sums, static_cast<std::size_t>(found - sums.begin()), target);
}

/// The same by a guide, which saves time where there are many, and changes nothing.
inline IntervalChoice choose(std::span<const double> sums, std::span<const std::uint32_t> guide, double u)
{
    const double target = u * sums.back();
    std::size_t at = guide[std::min(static_cast<std::size_t>(u * static_cast<double>(guide.size())), guide.size() - 1)];
    while (at > 0 && sums[at - 1] > target) // the step's own product was rounded
        --at;
    while (at < sums.size() && sums[at] <= target)
        ++at;
    return intervalAt(sums, at, target);
}

} // namespace torrance
