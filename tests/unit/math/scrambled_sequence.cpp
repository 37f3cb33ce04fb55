#include "math/scrambled_sequence.h"

#include "chi_square.h"

#include <gtest/gtest.h>
#include <set>

namespace torrance::test {
namespace {

TEST(ScrambledSequence, PutsOnePointIntoEveryElementaryBox)
{
    // Owen's scrambling keeps the (0, m, 2)-net that the first 2^m points are, and so must what stands in for it.
    constexpr int m = 8;
    for (std::uint64_t key = 1; key <= 20; ++key) {
        const ScrambledSequence points(hashNumbers({key}));
        for (int j = 0; j <= m; ++j) {
            std::set<std::pair<int, int>> boxes;
            for (std::uint32_t i = 0; i < (1u << m); ++i) {
                const dvec2 p = points[i];
                boxes.insert({static_cast<int>(std::ldexp(p.x, j)), static_cast<int>(std::ldexp(p.y, m - j))});
            }
            EXPECT_EQ(boxes.size(), 1u << m) << "key " << key << ", boxes of width 2^-" << j;
        }
    }
}

TEST(ScrambledSequence, EveryPointIsEvenOverTheKeys)
{
    // What makes means unbiased: one point, over many keys, fills 16 x 16 cells evenly. Keys as the program makes them.
    constexpr int kCells = 16, kKeys = 100000;
    const std::vector<std::uint32_t> indices = {0, 1, 2, 5, 100, 4095};
    for (const std::uint32_t index : indices) {
        const std::vector<double> expected(kCells * kCells, double(kKeys) / (kCells * kCells));
        std::vector<double> counts(expected.size(), 0.0);
        for (std::uint64_t key = 0; key < kKeys; ++key) {
            const dvec2 p = ScrambledSequence(hashNumbers({7, key}))[index];
            counts[static_cast<std::size_t>(static_cast<int>(p.y * kCells) * kCells +
                                            static_cast<int>(p.x * kCells))] += 1.0;
        }
        EXPECT_GE(chiSquareLikelihood(expected, counts), kFamilyLevel / double(indices.size())) << index;
    }
}

TEST(ScrambledSequence, NeighbouringKeysAreUnrelated)
{
    // The first points of keys k and k + 1: both first coordinates together are even over the square.
    constexpr int kCells = 16, kKeys = 100000;
    const std::vector<double> expected(kCells * kCells, double(kKeys) / (kCells * kCells));
    std::vector<double> counts(expected.size(), 0.0);
    for (std::uint64_t key = 0; key < kKeys; ++key) {
        const double a = ScrambledSequence(hashNumbers({key, 3}))[0].x,
                     b = ScrambledSequence(hashNumbers({key, 4}))[0].x;
        counts[static_cast<std::size_t>(static_cast<int>(a * kCells) * kCells + static_cast<int>(b * kCells))] += 1.0;
    }
    EXPECT_GE(chiSquareLikelihood(expected, counts), kFamilyLevel);
}

TEST(ScrambledSequence, HashDependsOnOrderAndCount)
{
    EXPECT_NE(hashNumbers({1, 2}), hashNumbers({2, 1}));
    EXPECT_NE(hashNumbers({0}), hashNumbers({0, 0}));
}

} // namespace
} // namespace torrance::test
