#include "math/cube.h"
#include "math/latlong.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

void expectSame(const dvec3& a, const dvec3& b, double tolerance)
{
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(LatLong, LiesAsThreeJsFilamentAndBlenderHaveIt)
{
    const auto expectUv = [](const dvec3& d, double u, double v) {
        const dvec2 uv = latLongFromDirection(d);
        EXPECT_NEAR(uv.x, u, 1e-15);
        EXPECT_NEAR(uv.y, v, 1e-15);
    };
    expectUv({1, 0, 0}, 0.5, 0.5);   // the middle of the picture
    expectUv({0, 0, 1}, 0.75, 0.5);  // to its right
    expectUv({0, 0, -1}, 0.25, 0.5); // to its left
    expectUv({-1, 0, 1e-300}, 1.0, 0.5);
    expectUv({0, 1, 0}, 0.5, 0.0);  // top row
    expectUv({0, -1, 0}, 0.5, 1.0); // bottom row
}

TEST(LatLong, GoesThereAndBack)
{
    for (double u = 0.03; u < 1.0; u += 0.1)
        for (const double v : {1e-9, 0.02, 0.3, 0.5, 0.81, 1.0 - 1e-9}) {
            const dvec2 uv = latLongFromDirection(directionFromLatLong({u, v}));
            EXPECT_NEAR(uv.x, u, 1e-7); // 1 - 1e-9 leaves the direction 1e-16 / 1e-9 to hold the column in
            EXPECT_NEAR(uv.y, v, 1e-15);
        }
}

TEST(LatLong, TexelsCoverTheSphere)
{
    double sum = 0.0;
    for (int row = 0; row < 37; ++row)
        sum += 74 * latLongTexelSolidAngle(row, 74, 37);
    EXPECT_NEAR(sum, 4.0 * kPi, 1e-13);
}

TEST(Cube, FacesFollowTheTableOfTheVulkanSpecification)
{
    // s = (sc / |ma| + 1) / 2, t = (tc / |ma| + 1) / 2 with sc, tc, ma from the table "Cube map face and coordinate
    // selection".
    struct Row
    {
        dvec3 major, s, t;
    };
    const Row rows[kCubeFaces] = {{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                  {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                  {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}};
    for (int face = 0; face < kCubeFaces; ++face) {
        const Row& row = rows[face];
        const dvec3 d = 2.0 * row.major + 0.5 * row.s - 1.2 * row.t; // a = 0.25, b = -0.6
        const CubePoint p = cubePoint(d);
        EXPECT_EQ(p.face, face);
        EXPECT_DOUBLE_EQ(p.a, 0.25);
        EXPECT_DOUBLE_EQ(p.b, -0.6);
        expectSame(2.0 * cubeVector(face, p.a, p.b), d, 1e-15);
    }
}

TEST(Cube, TexelsCoverTheSphere)
{
    for (const int size : {1, 2, 7, 64}) {
        double sum = 0.0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                sum += kCubeFaces * cubeTexelSolidAngle(x, y, size);
        EXPECT_NEAR(sum, 4.0 * kPi, 1e-11) << size;
    }
}

TEST(Cube, TexelSolidAngleIsTheIntegralOverTheTexel)
{
    // Midpoint rule on 200 x 200 cells of the corner texel of a 4 x 4 face.
    double sum = 0.0;
    const int n = 200;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double a = -1.0 + 0.5 * (i + 0.5) / n;
            const double b = -1.0 + 0.5 * (j + 0.5) / n;
            sum += 0.25 / (n * n) / std::pow(1.0 + a * a + b * b, 1.5);
        }
    EXPECT_NEAR(cubeTexelSolidAngle(0, 0, 4), sum, 1e-6 * sum);
}

} // namespace
} // namespace torrance
