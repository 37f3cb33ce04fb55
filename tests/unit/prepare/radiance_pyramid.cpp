#include "prepare/radiance_pyramid.h"

#include "math/cube.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

std::vector<float> cubeOf(int size, float (*radiance)(const dvec3&))
{
    std::vector<float> texels;
    for (int face = 0; face < kCubeFaces; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const float value = radiance(cubeTexelDirection(face, x, y, size));
                texels.insert(texels.end(), {value, 2 * value, 0.0f, 1.0f});
            }
    return texels;
}

TEST(RadiancePyramid, KeepsTheEnergyAtEveryLevel)
{
    const CubeLevels cube = radiancePyramid(
        cubeOf(16, [](const dvec3& d) { return d.x > 0.9 ? 1e6f : 0.5f + static_cast<float>(d.y) / 4; }), 16);
    ASSERT_EQ(cube.levels, 5);
    double first = 0.0;
    for (int level = 0; level < cube.levels; ++level) {
        const int size = cube.sizeOf(level);
        double energy = 0.0;
        for (int face = 0; face < kCubeFaces; ++face)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const float* texel =
                        &cube.data[static_cast<std::size_t>(level)][4 * cubeTexelIndex(face, x, y, size)];
                    EXPECT_EQ(texel[1], 2 * texel[0]);
                    EXPECT_EQ(texel[3], 1.0f);
                    energy += static_cast<double>(texel[0]) * cubeTexelSolidAngle(x, y, size);
                }
        if (level == 0)
            first = energy;
        EXPECT_NEAR(energy / first, 1.0, 1e-6) << level;
    }
}

} // namespace
} // namespace torrance
