#include "plan/primitive_facts.h"

#include "plan/shading_plan.h"
#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace torrance {
namespace {

void setBounds(Primitive& p)
{
    Box box;
    for (const vec3& position : p.positions)
        box.include(dvec3(position));
    p.boundsMin = box.least;
    p.boundsMax = box.greatest;
}

/// A cube of 12 triangles, each with vertices of its own, its fronts outside.
Primitive cube()
{
    Primitive p;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            vec3 corners[4];
            constexpr float kAcross[] = {-1, 1, 1, -1}, kAlong[] = {-1, -1, 1, 1};
            for (int i = 0; i < 4; ++i) {
                corners[i][axis] = side;
                corners[i][(axis + 1) % 3] = kAcross[i] * side;
                corners[i][(axis + 2) % 3] = kAlong[i];
            }
            for (const int i : {0, 1, 2, 0, 2, 3})
                p.positions.push_back(corners[i]);
        }
    for (std::uint32_t i = 0; i < p.positions.size(); ++i)
        p.indices.push_back(i);
    p.normals.assign(p.positions.size(), vec3(0, 0, 1));
    setBounds(p);
    return p;
}

/// Rings of a body of revolution about Y; its radius by the height in [-1, 1].
template <typename Radius>
Primitive revolved(const Radius& radius)
{
    constexpr std::uint32_t kRings = 24, kSides = 24;
    Primitive p;
    for (std::uint32_t ring = 0; ring <= kRings; ++ring)
        for (std::uint32_t side = 0; side < kSides; ++side) {
            const double y = -1.0 + 2.0 * ring / kRings, phi = 2.0 * std::numbers::pi * side / kSides;
            const double r = ring == 0 || ring == kRings ? 0.0 : radius(y);
            p.positions.emplace_back(r * std::sin(phi), y, r * std::cos(phi));
        }
    for (std::uint32_t ring = 0; ring < kRings; ++ring)
        for (std::uint32_t side = 0; side < kSides; ++side) {
            const std::uint32_t a = ring * kSides + side, b = ring * kSides + (side + 1) % kSides, c = b + kSides,
                                d = a + kSides;
            p.indices.insert(p.indices.end(), {a, b, c, a, c, d});
        }
    setBounds(p);
    return p;
}

double sphere(double y)
{
    return std::sqrt(1.0 - y * y);
}

TEST(StarBody, IsOneThatCanBeSeenWholeFromItsMiddle)
{
    EXPECT_TRUE(isStarBody(cube()));
    EXPECT_TRUE(isStarBody(revolved(sphere)));
    EXPECT_TRUE(isStarBody(revolved([](double y) { return sphere(y) * (0.6 + 0.4 * y * y); }))) << "a waist";
}

TEST(StarBody, HasNoHole)
{
    Primitive open = cube();
    open.indices.resize(open.indices.size() - 3);
    EXPECT_FALSE(isStarBody(open));
}

TEST(StarBody, ShowsItsFronts)
{
    Primitive inside = cube();
    for (std::size_t i = 0; i < inside.indices.size(); i += 3)
        std::swap(inside.indices[i], inside.indices[i + 1]);
    EXPECT_FALSE(isStarBody(inside));
    Primitive one = cube();
    std::swap(one.indices[3], one.indices[4]);
    EXPECT_FALSE(isStarBody(one));
}

// Seen from the middle, the rings of a mushroom's hat turn back.
TEST(StarBody, HidesNoneOfItFromItsMiddle)
{
    EXPECT_FALSE(isStarBody(revolved([](double y) { return y > 0.3 ? 3.0 * sphere(y) : 0.1; })));
}

TEST(StarBody, IsOneSheet)
{
    Primitive twice = cube();
    const Primitive again = cube();
    for (const std::uint32_t index : again.indices)
        twice.indices.push_back(index + static_cast<std::uint32_t>(twice.positions.size()));
    for (const vec3& p : again.positions)
        twice.positions.push_back(0.5f * p);
    EXPECT_FALSE(isStarBody(twice)) << "a cube within a cube";
}

TEST(StarBody, MayHaveTrianglesThatAreLines)
{
    Primitive p = cube();
    p.indices.insert(p.indices.end(), {0, 0, 1});
    EXPECT_TRUE(isStarBody(p));
    p.topology = Topology::lines;
    EXPECT_FALSE(isStarBody(p));
}

TEST(StarBody, IsPlannedForDoubleSidedMeshesOnly)
{
    Scene scene = test::sceneWith({.doubleSided = true});
    scene.primitives[0] = cube();
    scene.primitives[0].material = 0;
    const auto starBody = [&] { return makePlan(scene, test::settings()).batches[0].draws[0].starBody; };
    EXPECT_TRUE(starBody());
    scene.instances[0].worldFromObject[1][1] = 0.0; // flat: both sides are seen
    EXPECT_FALSE(starBody());
    scene.instances[0].worldFromObject[1][1] = 1.0;
    scene.materials[0].doubleSided = false;
    EXPECT_FALSE(starBody());
}

TEST(NormalsMayVanish, WhereTwoAreARightAngleApartOrOneIsZero)
{
    Primitive p = test::triangle(0);
    EXPECT_FALSE(normalsMayVanish(p));
    p.normals[1] = vec3(0.999f, 0.0f, 0.01f);
    EXPECT_FALSE(normalsMayVanish(p));
    p.normals[1] = vec3(1.0f, 0.0f, 0.0f);
    EXPECT_TRUE(normalsMayVanish(p));
    p.normals[1] = vec3(0.0f);
    EXPECT_TRUE(normalsMayVanish(p));
}

} // namespace
} // namespace torrance
