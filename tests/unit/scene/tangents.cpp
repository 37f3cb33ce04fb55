#include "scene/tangents.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

const glm::dmat3x2 kSame(1.0, 0.0, 0.0, 1.0, 0.0, 0.0);

/// A square of the plane z = 0 with normal +Z, its corners counter-clockwise from (0, 0).
Primitive square()
{
    Primitive p;
    p.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    p.normals.assign(4, vec3(0, 0, 1));
    p.uvs[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}}; // as pictures lie in glTF: v runs down
    p.indices = {0, 1, 2, 0, 2, 3};
    return p;
}

/// A unit sphere by longitude and latitude, u once around, v from the top down; poles are collapsed rows.
Primitive sphere(int columns, int rows)
{
    Primitive p;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const double phi = 2.0 * kPi * i / columns;
            const double theta = kPi * j / rows;
            const vec3 d(dvec3(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)));
            p.positions.push_back(d);
            p.normals.push_back(d);
            p.uvs[0].push_back(vec2(static_cast<float>(i) / columns, static_cast<float>(j) / rows));
        }
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const auto at = [&](int x, int y) { return static_cast<std::uint32_t>(y * (columns + 1) + x); };
            for (const std::uint32_t index :
                 {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i + 1, j)})
                p.indices.push_back(index);
        }
    return p;
}

void expectTangent(const vec4& tangent, const vec4& expected)
{
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(tangent[i], expected[i], 1e-6f) << "component " << i;
}

TEST(Tangents, FollowUAndTheBitangentRisesUpThePicture)
{
    const Primitive out = makeTangents(square(), 0, kSame);
    ASSERT_EQ(out.positions.size(), 4u);
    for (const vec4& t : out.tangents)
        expectTangent(t, {1, 0, 0, 1}); // cross(+Z, +X) = +Y: up the picture
}

TEST(Tangents, TurnWithTheTextureTransform)
{
    // u' = -v, v' = u: u' grows where v falls, which is +Y; v' falls towards -X = cross(+Z, +Y).
    const Primitive out = makeTangents(square(), 0, glm::dmat3x2(0.0, 1.0, -1.0, 0.0, 0.3, 0.2));
    for (const vec4& t : out.tangents)
        expectTangent(t, {0, 1, 0, 1});
}

TEST(Tangents, AMirroredMapHasTheOtherSign)
{
    Primitive p = square();
    for (vec2& uv : p.uvs[0])
        uv.x = 1.0f - uv.x;
    for (const vec4& t : makeTangents(p, 0, kSame).tangents)
        expectTangent(t, {-1, 0, 0, -1});
}

TEST(Tangents, SplitWhereTheMapIsMirrored)
{
    // Two squares side by side that show the same picture, the right one mirrored about their common edge.
    Primitive p;
    p.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    p.normals.assign(6, vec3(0, 0, 1));
    p.uvs[0] = {{0, 1}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {0, 0}};
    p.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
    const Primitive out = makeTangents(p, 0, kSame);
    EXPECT_EQ(out.positions.size(), 8u) << "the two vertices of the seam are there twice";
    for (std::size_t c = 0; c < 6; ++c)
        expectTangent(out.tangents[out.indices[c]], {1, 0, 0, 1});
    for (std::size_t c = 6; c < 12; ++c)
        expectTangent(out.tangents[out.indices[c]], {-1, 0, 0, -1});
    for (std::size_t c = 0; c < 12; ++c)
        EXPECT_EQ(out.positions[out.indices[c]], p.positions[p.indices[c]]) << "corner " << c;
}

TEST(Tangents, OfASphereAreItsParallels)
{
    const Primitive out = makeTangents(sphere(64, 32), 0, kSame);
    double worst = 0.0;
    for (std::size_t i = 0; i < out.positions.size(); ++i) {
        const dvec3 p(out.positions[i]);
        const dvec3 t(out.tangents[i]);
        EXPECT_NEAR(glm::length(t), 1.0, 1e-6);
        EXPECT_NEAR(glm::dot(t, p), 0.0, 1e-6);
        EXPECT_EQ(out.tangents[i].w, 1.0f);
        const double r = std::hypot(p.x, p.z);
        if (r > 0.2 && out.uvs[0][i].x > 0.0f && out.uvs[0][i].x < 1.0f) // inside, away from the poles
            worst = std::max(worst, glm::length(t - dvec3(p.z, 0, -p.x) / r));
    }
    // The chord of one column of 2 pi / 64 leaves its parallel by half of that angle; neighbours cancel it to second
    // order.
    EXPECT_LT(worst, 0.25 * std::pow(2.0 * kPi / 64, 2));
}

TEST(Tangents, WeighEachFaceByItsAngleAtTheCorner)
{
    // Two faces of one plane meet at the origin with 90 and 45 degrees. The first has u = x, v = -y. The second agrees
    // with it on their common edge and solves (0, 1, 0) = -B, (-1, 1, 0) = -T - 2 B: B = (0, -1, 0), T = (1, 1, 0).
    Primitive p;
    p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}};
    p.normals.assign(4, vec3(0, 0, 1));
    p.uvs[0] = {{0, 0}, {1, 0}, {0, -1}, {-1, -2}};
    p.indices = {0, 1, 2, 0, 2, 3};
    const dvec3 sum = 90.0 * dvec3(1, 0, 0) + 45.0 * glm::normalize(dvec3(1, 1, 0));
    const Primitive out = makeTangents(p, 0, kSame);
    expectTangent(out.tangents[out.indices[0]], vec4(vec3(glm::normalize(sum)), 1.0f));
}

TEST(Tangents, FacesWithoutAreaBorrowFromTheirNeighbours)
{
    Primitive p = square();
    p.positions.push_back({0.5f, 0.5f, 0});
    p.normals.push_back({0, 0, 1});
    p.uvs[0].push_back({0.5f, 0.5f});
    // collapsed in space at the corner 0, twice the same place; and a face whose map is a single point
    for (const std::uint32_t index : {0u, 0u, 1u})
        p.indices.push_back(index);
    const Primitive out = makeTangents(p, 0, kSame);
    for (std::size_t c = 6; c < 9; ++c)
        expectTangent(out.tangents[out.indices[c]], {1, 0, 0, 1});
    EXPECT_EQ(out.positions.size(), 4u) << "the unused vertex is gone, nothing was split";
}

TEST(Tangents, AreAlwaysUnitAndPerpendicularWhateverTheInput)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float big = std::numeric_limits<float>::max();
    for (const vec2& odd : {vec2(0, 0), vec2(nan, 0), vec2(big, -big), vec2(1e-38f, 1e-30f)})
        for (const vec3& place : {vec3(0, 0, 0), vec3(nan, 0, 0), vec3(big, big, -big), vec3(1e-30f, 0, 0)}) {
            Primitive p = square();
            p.uvs[0][2] = odd;
            p.positions[2] = place;
            for (const vec4& t : makeTangents(p, 0, kSame).tangents) {
                EXPECT_NEAR(glm::length(vec3(t)), 1.0f, 1e-6f);
                EXPECT_NEAR(t.z, 0.0f, 1e-6f);
                EXPECT_EQ(std::abs(t.w), 1.0f);
            }
        }
    Primitive flat = square();
    flat.uvs[0].assign(4, vec2(0.5f)); // no map at all
    for (const vec4& t : makeTangents(flat, 0, kSame).tangents)
        EXPECT_NEAR(glm::length(vec3(t)), 1.0f, 1e-6f);
    flat.normals.assign(4, vec3(0));
    for (const vec4& t : makeTangents(flat, 0, kSame).tangents)
        EXPECT_NEAR(glm::length(vec3(t)), 1.0f, 1e-6f);
}

TEST(Tangents, DoNotDependOnHowVerticesAreShared)
{
    const Primitive shared = sphere(12, 6);
    Primitive soup = shared;
    soup.positions.clear(), soup.normals.clear(), soup.uvs[0].clear(), soup.indices.clear();
    for (const std::uint32_t i : shared.indices) {
        soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
        soup.positions.push_back(shared.positions[i]);
        soup.normals.push_back(shared.normals[i]);
        soup.uvs[0].push_back(shared.uvs[0][i]);
    }
    const Primitive a = makeTangents(shared, 0, kSame), b = makeTangents(soup, 0, kSame);
    for (std::size_t c = 0; c < a.indices.size(); ++c)
        ASSERT_EQ(a.tangents[a.indices[c]], b.tangents[b.indices[c]]) << "corner " << c;
}

TEST(Tangents, KeepEveryOtherAttribute)
{
    Primitive p = square();
    p.uvs[1] = {{5, 5}, {6, 5}, {6, 6}, {5, 6}};
    p.colors.assign(4, vec4(0.25f));
    p.material = 3;
    p.name = "a";
    const Primitive out = makeTangents(p, 0, kSame);
    EXPECT_EQ(out.material, 3);
    EXPECT_EQ(out.name, "a");
    ASSERT_EQ(out.uvs[1].size(), 4u);
    for (std::size_t c = 0; c < 6; ++c)
        EXPECT_EQ(out.uvs[1][out.indices[c]], p.uvs[1][p.indices[c]]);
    EXPECT_EQ(out.colors, p.colors);
}

} // namespace
} // namespace torrance
