#include "math/guided_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace torrance {
namespace {

std::vector<double> runningSums(const std::vector<double>& lengths)
{
    std::vector<double> sums(lengths.size());
    std::partial_sum(lengths.begin(), lengths.end(), sums.begin());
    return sums;
}

/// Lengths of many sizes, half of them none.
std::vector<double> spread(std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<double> lengths(count);
    for (double& length : lengths)
        length = random() % 2 == 0 ? 0.0 : std::exp2(double(random() % 40) - 20.0);
    lengths[count / 2] = 1.0; // one has length in any case
    return lengths;
}

// The guide only saves time: every choice is that of a search over all sums.
TEST(GuidedChoice, IsTheIntervalThatABinarySearchFinds)
{
    for (const std::size_t count : {1u, 2u, 3u, 64u, 1000u})
        for (unsigned seed = 0; seed < 10; ++seed) {
            const std::vector<double> lengths = spread(count, seed), sums = runningSums(lengths);
            std::vector<std::uint32_t> guide(count);
            makeGuide(sums, guide);
            std::vector<double> places = {0.0, 0x1p-60, 0.5, 1.0 - 0x1p-53, 1.0};
            for (std::size_t i = 0; i < count; ++i) { // where intervals and steps begin, and beside it
                places.push_back(sums[i] / sums.back());
                places.push_back(double(i) / double(count));
                places.push_back(std::nextafter(double(i) / double(count), 0.0));
            }
            for (const double u : places) {
                const IntervalChoice chosen = choose(sums, guide, u);
                ASSERT_EQ(choose(sums, u).index, chosen.index) << u;
                ASSERT_EQ(choose(sums, u).rest, chosen.rest) << u;
                const double target = u * sums.back();
                ASSERT_GT(lengths[chosen.index], 0.0) << u;
                const auto found = std::upper_bound(sums.begin(), sums.end(), target);
                if (found != sums.end()) {
                    ASSERT_EQ(chosen.index, std::size_t(found - sums.begin())) << u;
                    const double before = sums[chosen.index] - lengths[chosen.index];
                    ASSERT_NEAR(before + chosen.rest * lengths[chosen.index], target, 1e-12 * sums.back());
                } else {
                    ASSERT_EQ(chosen.rest, 1.0) << u;
                }
            }
        }
}

} // namespace
} // namespace torrance
