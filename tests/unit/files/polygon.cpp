// Polygons cut into triangles.
#include "files/polygon.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

/// In a tilted plane, so that no axis is special.
std::vector<dvec3> tilted(const std::vector<dvec2>& flat)
{
    const dvec3 u = glm::normalize(dvec3(1.0, 2.0, -0.5));
    const dvec3 v = glm::normalize(glm::cross(dvec3(0.3, -0.2, 1.0), u));
    std::vector<dvec3> corners;
    for (const dvec2& p : flat)
        corners.push_back(dvec3(5.0, -3.0, 2.0) + p.x * u + p.y * v);
    return corners;
}

std::vector<std::uint32_t> cut(const std::vector<dvec3>& corners)
{
    std::vector<std::uint32_t> triangles;
    CuttingBudget budget;
    EXPECT_TRUE(triangulate(corners, triangles, budget));
    EXPECT_EQ(triangles.size(), 3 * (corners.size() - 2));
    return triangles;
}

/// A cut is right where no triangle is turned over and the areas add up: then nothing overlaps and nothing is missing.
void expectExactCut(const std::vector<dvec2>& flat)
{
    const std::vector<dvec3> corners = tilted(flat);
    const dvec3 whole = newellVector(corners);
    const std::vector<std::uint32_t> triangles = cut(corners);
    double sum = 0.0;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const dvec3 area = glm::cross(corners[triangles[i + 1]] - corners[triangles[i]],
                                      corners[triangles[i + 2]] - corners[triangles[i]]);
        EXPECT_GE(glm::dot(area, whole), -1e-9);
        sum += glm::length(area);
    }
    EXPECT_NEAR(sum, glm::length(whole), 1e-9 * glm::length(whole));
}

TEST(Polygon, ConvexOnes)
{
    expectExactCut({{0, 0}, {1, 0}, {0, 1}});
    expectExactCut({{0, 0}, {2, 0}, {2, 1}, {0, 1}});
    expectExactCut({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}); // with corners on its edges
    std::vector<dvec2> circle;
    for (int i = 0; i < 300; ++i)
        circle.emplace_back(std::cos(i * kPi / 150.0), std::sin(i * kPi / 150.0));
    expectExactCut(circle);
}

TEST(Polygon, ConcaveOnes)
{
    expectExactCut({{0, 0}, {1, 0.2}, {2, 0}, {1, 2}}); // an arrowhead
    expectExactCut({{1, 2}, {0, 0}, {1, 0.2}, {2, 0}}); // from another corner: the shorter diagonal would be wrong
    expectExactCut({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});                 // a U
    expectExactCut({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}); // with a hole
    std::vector<dvec2> star;
    for (int i = 0; i < 60; ++i)
        star.push_back((i % 2 == 0 ? 1.0 : 0.2) * dvec2(std::cos(i * kPi / 30.0), std::sin(i * kPi / 30.0)));
    expectExactCut(star);
    std::vector<dvec2> spiral;
    for (int i = 0; i < 100; ++i)
        spiral.push_back((1.0 + 0.1 * i) * dvec2(std::cos(0.2 * i), std::sin(0.2 * i)));
    for (int i = 99; i >= 0; --i)
        spiral.push_back((0.7 + 0.1 * i) * dvec2(std::cos(0.2 * i), std::sin(0.2 * i)));
    expectExactCut(spiral);
}

TEST(Polygon, QuadsAreCutAlongTheShorterDiagonal)
{
    const std::vector<dvec3> corners = {{0, 0, 0}, {3, 0, 0}, {4, 1, 0}, {1, 1, 0}}; // 1 to 3 is the shorter one
    EXPECT_EQ(cut(corners), (std::vector<std::uint32_t>{0, 1, 3, 1, 2, 3}));
}

TEST(Polygon, WhatHasNoInsideIsCutAllTheSame)
{
    cut(tilted({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));         // crosses itself
    cut(tilted({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 0}})); // a line
    cut(std::vector<dvec3>(7, dvec3(1.0)));                // a point
}

TEST(Polygon, ABudgetEndsWhatWouldTakeForever)
{
    std::vector<dvec2> comb; // every tooth is reflex at its root
    for (int i = 0; i < 500; ++i) {
        comb.emplace_back(i, 0.0);
        comb.emplace_back(i + 0.5, i % 2 == 0 ? 5.0 : -5.0);
    }
    std::vector<std::uint32_t> triangles;
    CuttingBudget budget{1000};
    EXPECT_FALSE(triangulate(tilted(comb), triangles, budget));
}

TEST(Polygon, TwiceTheAreaAlongTheNormal)
{
    const std::vector<dvec3> square = {{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
    EXPECT_EQ(newellVector(square), dvec3(0.0, 0.0, 8.0));
}

} // namespace
} // namespace torrance
