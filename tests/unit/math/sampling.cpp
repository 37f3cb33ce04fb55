#include "math/sampling.h"
#include "math/low_discrepancy.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace torrance {
namespace {

TEST(LowDiscrepancy, MirrorsTheBitsAtTheBinaryPoint)
{
    EXPECT_EQ(radicalInverse2(0), 0.0);
    EXPECT_EQ(radicalInverse2(1), 0.5);
    EXPECT_EQ(radicalInverse2(6), 0.375); // 110 -> 0.011
    EXPECT_EQ(radicalInverse2(0xffffffffu), 1.0 - 0x1p-32);
}

TEST(LowDiscrepancy, PutsOnePointIntoEveryElementaryBox)
{
    // A (0, m, 2) net: each of the 16 boxes 2^-j x 2^-(4-j) holds exactly one of 16 points.
    for (int j = 0; j <= 4; ++j) {
        std::vector<int> hits(16, 0);
        for (std::uint32_t i = 0; i < 16; ++i) {
            const dvec2 p = hammersley(i, 16);
            const int column = static_cast<int>(p.x * (1 << j));
            const int row = static_cast<int>(p.y * (1 << (4 - j)));
            ++hits[static_cast<std::size_t>(column * (1 << (4 - j)) + row)];
        }
        EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), 16) << "boxes of width 2^-" << j;
    }
}

constexpr std::uint32_t kCount = 1u << 16;

TEST(Sampling, CosineHasTheMomentsOfTheCosine)
{
    // E[z] = 2/3, E[z^2] = 1/2, E[x^2] = 1/4 of the density z / pi.
    dvec3 first(0.0), second(0.0);
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const dvec3 d = sampleCosine(hammersley(i, kCount));
        ASSERT_NEAR(glm::length(d), 1.0, 1e-12);
        first += d / static_cast<double>(kCount);
        second += d * d / static_cast<double>(kCount);
    }
    EXPECT_NEAR(first.z, 2.0 / 3.0, 1e-4);
    EXPECT_NEAR(first.x, 0.0, 1e-4);
    EXPECT_NEAR(second.z, 0.5, 1e-4);
    EXPECT_NEAR(second.x, 0.25, 1e-4);
}

TEST(Sampling, GgxNormalsFollowTheirClosedDistribution)
{
    // P(tan theta < s) = s^2 / (s^2 + alpha^2): half of the normals are flatter than tan theta = alpha.
    const double alpha = 0.3;
    int flat = 0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const dvec3 h = sampleGgxNormal(dvec2(alpha), hammersley(i, kCount));
        flat += std::hypot(h.x, h.y) / h.z < alpha;
    }
    EXPECT_NEAR(static_cast<double>(flat) / kCount, 0.5, 1e-3);
}

TEST(Sampling, VisibleNormalsHaveTheirDensity)
{
    // The mean of 1 / density over the drawn normals inside a region is the region's solid angle, whatever the density:
    // here the cap NoH > 0.8 of 2 pi 0.2 sr, all of it visible from v (v . h > 0 there).
    const dvec3 v = glm::normalize(dvec3(0.6, 0.2, 0.9));
    const dvec2 alpha(0.6, 0.35);
    double area = 0.0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const dvec3 h = sampleGgxVisibleNormal(v, alpha, hammersley(i, kCount));
        const double stretched = h.x * h.x / (alpha.x * alpha.x) + h.y * h.y / (alpha.y * alpha.y) + h.z * h.z;
        const double D = 1.0 / (kPi * alpha.x * alpha.y * stretched * stretched); // Heitz 2014, eq. 85
        const double slope2 = (v.x * v.x * alpha.x * alpha.x + v.y * v.y * alpha.y * alpha.y) / (v.z * v.z);
        const double G1 = 2.0 / (1.0 + std::sqrt(1.0 + slope2));
        const double density = G1 * std::max(0.0, glm::dot(v, h)) * D / v.z;
        if (h.z > 0.8)
            area += 1.0 / density / kCount;
    }
    EXPECT_NEAR(area, 2.0 * kPi * 0.2, 2e-3 * 2.0 * kPi * 0.2);
}

} // namespace
} // namespace torrance
