// The shapes that a material is shown on.
#include "scene/shape_mesh.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace torrance {
namespace {

std::array<std::uint32_t, 3> triangle(const Primitive& mesh, std::size_t number)
{
    return {mesh.indices[3 * number], mesh.indices[3 * number + 1], mesh.indices[3 * number + 2]};
}

dvec3 areaVector(const Primitive& mesh, const std::array<std::uint32_t, 3>& t)
{
    const auto at = [&](std::size_t k) { return dvec3(mesh.positions[t[k]]); };
    return 0.5 * glm::cross(at(1) - at(0), at(2) - at(0));
}

/// Fronts face outwards, frames are orthonormal, and the tangents point where u grows.
void expectSoundShape(const Primitive& mesh)
{
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-6f);
        EXPECT_NEAR(glm::length(vec3(mesh.tangents[i])), 1.0f, 1e-6f);
        EXPECT_NEAR(glm::dot(vec3(mesh.tangents[i]), mesh.normals[i]), 0.0f, 1e-6f);
    }
    for (std::size_t i = 0; i < mesh.indices.size() / 3; ++i) {
        const auto t = triangle(mesh, i);
        const dvec3 area = areaVector(mesh, t);
        EXPECT_GT(glm::length(area), 0.0);
        const dvec3 normal = dvec3(mesh.normals[t[0]]) + dvec3(mesh.normals[t[1]]) + dvec3(mesh.normals[t[2]]);
        EXPECT_GT(glm::dot(area, normal), 0.0) << "triangle " << i;
        // Position as a linear function of uv: its derivatives lie along the tangent, and against the bitangent.
        const dvec2 a = dvec2(mesh.uvs[0][t[1]]) - dvec2(mesh.uvs[0][t[0]]);
        const dvec2 b = dvec2(mesh.uvs[0][t[2]]) - dvec2(mesh.uvs[0][t[0]]);
        const dvec3 p = dvec3(mesh.positions[t[1]]) - dvec3(mesh.positions[t[0]]);
        const dvec3 q = dvec3(mesh.positions[t[2]]) - dvec3(mesh.positions[t[0]]);
        const double determinant = a.x * b.y - b.x * a.y;
        const dvec3 alongU = (p * b.y - q * a.y) / determinant, alongV = (q * a.x - p * b.x) / determinant;
        const vec4 tangent = mesh.tangents[t[1]];
        const dvec3 bitangent = glm::cross(dvec3(mesh.normals[t[1]]), dvec3(vec3(tangent))) * double(tangent.w);
        EXPECT_GT(glm::dot(glm::normalize(alongU), dvec3(vec3(tangent))), 0.99) << "triangle " << i;
        EXPECT_LT(glm::dot(glm::normalize(alongV), bitangent), -0.99) << "triangle " << i;
    }
}

TEST(ShapeMesh, FramesFollowTheCoordinates)
{
    expectSoundShape(sphereMesh());
    expectSoundShape(planeMesh());
    expectSoundShape(cubeMesh());
}

TEST(ShapeMesh, TheSphereIsRoundToWhatItsResolutionAllows)
{
    const Primitive mesh = sphereMesh();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(dvec3(mesh.positions[i])), 1.0, 1e-7);
        EXPECT_EQ(mesh.positions[i], mesh.normals[i]);
    }
    double deepest = 0.0, area = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size() / 3; ++i) {
        const auto t = triangle(mesh, i);
        for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)})
            deepest =
                std::max(deepest, 1.0 - glm::length(0.5 * (dvec3(mesh.positions[t[static_cast<std::size_t>(a)]]) +
                                                           dvec3(mesh.positions[t[static_cast<std::size_t>(b)]]))));
        area += glm::length(areaVector(mesh, t));
    }
    // A chord of 2 pi / n lies 1 - cos(pi / n) below its arc; the diagonal of a square of two such, twice that.
    const double chord = 1.0 - std::cos(kPi / kSphereSegments);
    EXPECT_NEAR(deepest, 2.0 * chord, 0.02 * chord);
    EXPECT_NEAR(area, 4.0 * kPi, 4.0 * kPi * 4.0 * chord) << "and nothing is missing";
    EXPECT_LT(area, 4.0 * kPi);
}

TEST(ShapeMesh, TheSphereIsClosed)
{
    // Every edge, by the places of its ends, belongs to two triangles that run along it in opposite directions.
    const Primitive mesh = sphereMesh();
    const auto less = [](const std::array<float, 6>& a, const std::array<float, 6>& b) { return a < b; };
    std::map<std::array<float, 6>, int, decltype(less)> edges(less);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const vec3 &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
        // The seam is computed at -pi and at pi: rounded to a millionth it is one place.
        const auto rounded = [](float x) { return std::round(x * 1e6f) / 1e6f + 0.0f; };
        const std::array<float, 3> p = {rounded(a.x), rounded(a.y), rounded(a.z)};
        const std::array<float, 3> q = {rounded(b.x), rounded(b.y), rounded(b.z)};
        const bool forward = p < q;
        const auto& first = forward ? p : q;
        const auto& second = forward ? q : p;
        edges[{first[0], first[1], first[2], second[0], second[1], second[2]}] += forward ? 1 : -1;
    }
    for (const auto& [edge, balance] : edges)
        ASSERT_EQ(balance, 0);
}

TEST(ShapeMesh, PicturesStandUprightInFront)
{
    const Primitive plane = planeMesh();
    EXPECT_EQ(plane.positions[0], vec3(-1, 1, 0));
    EXPECT_EQ(plane.uvs[0][0], vec2(0, 0));
    const Primitive sphere = sphereMesh();
    for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
        const vec2 uv = sphere.uvs[0][i];
        const vec3 expected = uv == vec2(0.5f) ? vec3(0, 0, 1) : uv == vec2(0.75f, 0.5f) ? vec3(1, 0, 0) : vec3(0);
        if (expected != vec3(0)) {
            EXPECT_NEAR(glm::distance(sphere.positions[i], expected), 0.0f, 1e-6f);
        }
    }
    const Primitive cube = cubeMesh();
    EXPECT_EQ(cube.boundsMin, dvec3(-1.0));
    EXPECT_EQ(cube.boundsMax, dvec3(1.0));
    EXPECT_EQ(cube.indices.size(), 36u);
}

} // namespace
} // namespace torrance
