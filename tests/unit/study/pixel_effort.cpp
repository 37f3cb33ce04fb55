#include "study/pixel_effort.h"

#include "math/replicates.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace torrance {
namespace {

// What the half intervals come to, as a share of all light.
double noiseOf(const std::vector<PixelSpread>& pixels, const std::vector<int>& directions)
{
    double widths = 0.0, norms = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        widths += kStudent95 * std::sqrt(pixels[i].variance / directions[i]);
        norms += pixels[i].norm;
    }
    return widths / norms;
}

const std::vector<PixelSpread> kPixels = {{1.0, 4.0}, {2.0, 0.25}, {0.5, 100.0}, {3.0, 1.0}};

TEST(PixelEffort, BringsTheNoiseToWhatIsAsked)
{
    for (const double noise : {0.1, 0.01, 0.002}) {
        const double reached = noiseOf(kPixels, directionsFor(kPixels, noise, 1, 1));
        EXPECT_LE(reached, noise);
        EXPECT_GT(reached, 0.99 * noise); // whole directions, of hundreds
    }
}

// Lagrange's condition: no two pixels can trade directions and gain.
TEST(PixelEffort, NoTradeOfDirectionsLowersTheNoise)
{
    const std::vector<int> directions = directionsFor(kPixels, 0.01, 1, 1);
    const double least = noiseOf(kPixels, directions);
    for (std::size_t from = 0; from < kPixels.size(); ++from)
        for (std::size_t to = 0; to < kPixels.size(); ++to) {
            std::vector<int> traded = directions;
            const int amount = directions[from] / 10;
            traded[from] -= amount;
            traded[to] += amount;
            EXPECT_GE(noiseOf(kPixels, traded), least * (1.0 - 1e-9)) << from << " to " << to;
        }
}

TEST(PixelEffort, StaysWithinItsBoundsAndSteps)
{
    const std::vector<int> few = directionsFor(kPixels, 0.5, 128, 64);
    for (const int n : few)
        EXPECT_TRUE(n >= 128 && n % 64 == 0) << n;
    const std::vector<int> many = directionsFor(kPixels, 1e-9, 128, 64);
    const double all = std::accumulate(many.begin(), many.end(), 0.0);
    EXPECT_LE(all, kMostDirectionsInAll + 4 * 64);
    EXPECT_GT(all, 0.99 * kMostDirectionsInAll);
    for (const int n : directionsFor(std::vector<PixelSpread>{{0.0, 0.0}, {1.0, 0.0}}, 0.01, 128, 64))
        EXPECT_EQ(n, 128) << "nothing to find out";
}

} // namespace
} // namespace torrance
