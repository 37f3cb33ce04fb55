// KHR_texture_transform from matrices: exactly the ones that it was, wherever doubles allow.
#include "files/uv_transform.h"

#include <gtest/gtest.h>
#include <random>

namespace torrance {
namespace {

double distance(const glm::dmat3x2& a, const glm::dmat3x2& b)
{
    double largest = 0.0;
    for (int column = 0; column < 2; ++column)
        largest = std::max(largest, glm::length(a[column] - b[column]) / glm::length(b[column]));
    return largest;
}

TEST(UvTransform, GivesItsMatrixAgainBitByBit)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> angle(-kPi, kPi), scale(-4.0, 4.0);
    int exact = 0;
    constexpr int kCases = 5000;
    for (int i = 0; i < kCases; ++i) {
        const UvTransform made{dvec2(scale(random), scale(random)), angle(random), dvec2(scale(random), scale(random))};
        const glm::dmat3x2 matrix = matrixOf(made);
        const glm::dmat3x2 again = matrixOf(uvTransformOf(matrix));
        EXPECT_LE(distance(again, matrix), kUvTransformError) << "rotation " << made.rotation;
        EXPECT_EQ(again[2], matrix[2]);
        exact += again == matrix ? 1 : 0;
    }
    EXPECT_EQ(exact, kCases) << "each of these has a transform that gives it: the one that it was made from";
}

TEST(UvTransform, KeepsWhatPeopleType)
{
    for (const double degrees : {0.0, 30.0, 45.0, 90.0, -90.0, 135.0, 180.0, -180.0, 1e-9})
        for (const dvec2 scale : {dvec2(1, 1), dvec2(2, 0.1), dvec2(-1, 1), dvec2(1, -1), dvec2(-3, -3)}) {
            const glm::dmat3x2 matrix = matrixOf({dvec2(0.5, -1.0 / 3.0), degrees * kPi / 180.0, scale});
            EXPECT_EQ(matrixOf(uvTransformOf(matrix)), matrix)
                << degrees << " degrees, scales " << scale.x << " " << scale.y;
        }
}

TEST(UvTransform, OfScalesAloneHasNoRotation)
{
    for (const dvec2 scale : {dvec2(1, 1), dvec2(-1, 1), dvec2(1.0 / 3.0, -7), dvec2(0, 0), dvec2(0, 2)}) {
        const UvTransform transform = uvTransformOf({dvec2(scale.x, 0), dvec2(0, scale.y), dvec2(1, 2)});
        EXPECT_EQ(transform.rotation, 0.0);
        EXPECT_EQ(transform.scale, scale);
        EXPECT_EQ(transform.offset, dvec2(1, 2));
    }
}

TEST(UvTransform, SurvivesColumnsOfNoLength)
{
    const glm::dmat3x2 onlySecond(dvec2(0.0), 2.0 * dvec2(std::sin(0.3), std::cos(0.3)), dvec2(0.0));
    EXPECT_EQ(matrixOf(uvTransformOf(onlySecond)), onlySecond);
    const glm::dmat3x2 onlyFirst(2.0 * dvec2(std::cos(0.3), -std::sin(0.3)), dvec2(0.0), dvec2(0.0));
    EXPECT_EQ(matrixOf(uvTransformOf(onlyFirst)), onlyFirst);
}

TEST(UvTransform, HasNoPlaceForAShear)
{
    const glm::dmat3x2 shear(dvec2(1, 0), dvec2(0.5, 1), dvec2(0.0));
    EXPECT_GT(distance(matrixOf(uvTransformOf(shear)), shear), 0.1);
}

} // namespace
} // namespace torrance
