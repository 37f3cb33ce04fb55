#include "study/pixel_error.h"

#include "math/scrambled_sequence.h"
#include "study/pixel_sample.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace torrance {
namespace {

/// kReplicates estimates of `truth` with normal noise of this deviation (Box & Muller).
Replicates noisy(double truth, double sigma, std::uint64_t key)
{
    Replicates estimates;
    for (std::uint64_t r = 0; r < kReplicates; ++r) {
        const dvec2 u = ScrambledSequence(hashNumbers({key, r}))[0];
        estimates.values[r] = dvec3(truth + sigma * std::sqrt(-2.0 * std::log(u.x)) * std::cos(2.0 * kPi * u.y), 0, 0);
    }
    return estimates;
}

TEST(PixelError, EnclosesTheTruthOnAverageHoweverSmallItIs)
{
    constexpr int kPixels = 4000;
    for (const double truth : {0.0, 0.05, 0.25, 1.0, 5.0}) { // in deviations of the mean of one pixel
        double above = 0.0, below = 0.0;
        for (std::uint64_t i = 0; i < kPixels; ++i) {
            const PixelError error = pixelError(noisy(truth, std::sqrt(double(kReplicates)), i), noisy(1.0, 0.0, i));
            above += error.above / kPixels;
            below += error.below / kPixels;
        }
        const double scatter = 4.0 / std::sqrt(double(kPixels)); // four deviations of a mean of deviation 1
        EXPECT_GT(above, truth - scatter);
        EXPECT_LT(below, truth + scatter);
        // E|x + noise| of a normal distribution: x (2 Phi(x) - 1) + 2 phi(x).
        const double phi = std::exp(-0.5 * truth * truth) / std::sqrt(2.0 * kPi);
        EXPECT_NEAR(above, truth * std::erf(truth / std::sqrt(2.0)) + 2.0 * phi, scatter);
    }
}

TEST(PixelError, WithoutNoiseIsExact)
{
    const PixelError error = pixelError(dvec3(0.5, 0.0, 2.0), [] {
        Replicates truth;
        truth.values.fill(dvec3(1.0, 0.0, 1.0));
        return truth;
    }());
    EXPECT_DOUBLE_EQ(error.above, 1.5);
    EXPECT_DOUBLE_EQ(error.below, 1.5);
    EXPECT_DOUBLE_EQ(error.norm, 2.0);
    const Bounded relative = relativeError(error, 1.0);
    EXPECT_DOUBLE_EQ(relative.value, 0.5);
    EXPECT_NEAR(relative.low, 0.5, 1e-12);
    EXPECT_NEAR(relative.high, 0.5, 1e-12);
    EXPECT_FALSE(std::isfinite(pixelError(dvec3(std::nan("")), Replicates()).above));
}

TEST(DrawSample, TakesTwoOfEachStratumAndEveryPixelEquallyOften)
{
    std::vector<int> times(50);
    constexpr int kSeeds = 4000;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        std::set<std::size_t> drawn;
        std::size_t population = 0;
        for (const PixelStratum& stratum : drawSample(times.size(), 17, seed)) {
            EXPECT_GE(stratum.drawn.size(), 2u);
            for (const std::size_t pixel : stratum.drawn) {
                EXPECT_TRUE(drawn.insert(pixel).second);
                EXPECT_GE(pixel, population);
                EXPECT_LT(pixel, population + stratum.population);
                ++times[pixel];
            }
            population += stratum.population;
        }
        EXPECT_EQ(population, times.size());
        EXPECT_EQ(drawn.size(), 17u);
    }
    // 8 strata of 6 or 7 pixels: a pixel is drawn with 2/6 or 2/7, 3/7 in the last, five deviations of a count at most.
    for (std::size_t i = 0; i < times.size(); ++i) {
        const auto share = [&](double p) {
            return std::abs(times[i] - kSeeds * p) < 5.0 * std::sqrt(kSeeds * p * (1 - p));
        };
        EXPECT_TRUE(share(2.0 / 6.0) || share(2.0 / 7.0) || share(3.0 / 7.0)) << i << ": " << times[i];
    }
    EXPECT_EQ(drawSample(5, 16, 0).front().drawn.size(), 5u) << "all there are";
}

} // namespace
} // namespace torrance
