// Against a rasterizer of its own: what a device would draw that rounds vertices to floats and then to a grid.
#include "scene/visible_triangles.h"

#include "scene/camera_fit.h"
#include "scene/camera_view.h"
#include "scene/shape_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace torrance {
namespace {

constexpr unsigned kSubpixelBits = 8;
constexpr ivec2 kPixels(160, 100);

struct Mesh
{
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    Box box;
};

/// Triangles of sides about `size`, all over a cube of side 2 about the origin.
Mesh randomTriangles(int count, double size, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto point = [&] { return dvec3(unit(random), unit(random), unit(random)); };
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const dvec3 middle = point();
        for (int k = 0; k < 3; ++k) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.emplace_back(middle + size * point());
            mesh.box.include(dvec3(mesh.positions.back()));
        }
    }
    return mesh;
}

Camera cameraAt(double distance, Camera::Kind kind = Camera::Kind::perspective)
{
    Camera camera = orbitCamera({0.4, 1.1}, distance, dvec3(0.0), 0.7);
    camera.kind = kind;
    camera.nearPlane = 0.01;
    camera.farPlane = 100.0;
    return camera;
}

VertexTransform transformOf(const Camera& camera, const dmat3& linear = dmat3(1.0))
{
    const dmat4 clip = projectionMatrix(camera, double(kPixels.x) / kPixels.y) * dmat4(dmat3(viewFromWorld(camera)));
    return {.clipFromEye = mat4(clip), .linear = mat3(linear), .translation = vec3(-cameraPosition(camera))};
}

using Snapped = std::array<std::int64_t, 2>; // 2^-kSubpixelBits pixels

Snapped snapped(const VertexTransform& t, const vec3& p)
{
    const vec4 clip = t.clipFromEye * vec4(t.linear * p + t.translation, 1.0f);
    const vec2 place = (vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(kPixels);
    return {std::llround(std::ldexp(place.x, kSubpixelBits)), std::llround(std::ldexp(place.y, kSubpixelBits))};
}

std::int64_t turn(const Snapped& a, const Snapped& b, const Snapped& c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The pixels of whose centres a triangle holds one, its rim included; none where its visible side is the other.
std::vector<ivec2> covered(const std::array<Snapped, 3>& corners, VisibleSides sides)
{
    const std::int64_t area = turn(corners[0], corners[1], corners[2]);
    if (area == 0 || (sides == VisibleSides::clockwise && area < 0) ||
        (sides == VisibleSides::counterClockwise && area > 0))
        return {};
    std::vector<ivec2> pixels;
    constexpr std::int64_t kStep = 1 << kSubpixelBits;
    const auto [left, right] = std::minmax({corners[0][0], corners[1][0], corners[2][0]});
    const auto [top, bottom] = std::minmax({corners[0][1], corners[1][1], corners[2][1]});
    for (std::int64_t y = std::max<std::int64_t>(top / kStep - 1, 0); y < kPixels.y && y * kStep <= bottom; ++y)
        for (std::int64_t x = std::max<std::int64_t>(left / kStep - 1, 0); x < kPixels.x && x * kStep <= right; ++x) {
            const Snapped centre = {x * kStep + kStep / 2, y * kStep + kStep / 2};
            bool inside = true;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::int64_t side = turn(corners[i], corners[(i + 1) % 3], centre);
                inside &= area > 0 ? side >= 0 : side <= 0;
            }
            if (inside)
                pixels.emplace_back(x, y);
        }
    return pixels;
}

/// The numbers of the triangles that are kept.
std::set<std::uint32_t> keptOf(const Mesh& mesh, const TriangleView& view, bool avx2 = processorHasAvx2())
{
    std::vector<vec2> places(mesh.positions.size());
    placeVertices(view, mesh.positions, places);
    std::vector<std::uint32_t> kept(mesh.indices.size());
    kept.resize(keepVisible(view, mesh.indices, places, kept.data(), avx2));
    EXPECT_EQ(kept.size() % 3, 0u);
    std::set<std::uint32_t> numbers;
    for (std::size_t i = 0; i < kept.size(); i += 3) {
        EXPECT_EQ(kept[i + 1], kept[i] + 1) << "a triangle's own";
        EXPECT_EQ(kept[i + 2], kept[i] + 2);
        numbers.insert(kept[i] / 3);
    }
    EXPECT_EQ(numbers.size(), kept.size() / 3) << "once each";
    return numbers;
}

struct Count
{
    int drawn = 0, kept = 0, all = 0;
};

Count expectNoneLost(const Mesh& mesh, const VertexTransform& transform, VisibleSides sides)
{
    const auto view = triangleView(transform, mesh.box, kPixels, sides, kSubpixelBits);
    EXPECT_TRUE(view);
    if (!view)
        return {};
    const std::set<std::uint32_t> kept = keptOf(mesh, *view);
    Count count = {.kept = int(kept.size()), .all = int(mesh.indices.size() / 3)};
    for (std::uint32_t i = 0; i < mesh.indices.size() / 3; ++i) {
        std::array<Snapped, 3> corners;
        for (std::uint32_t k = 0; k < 3; ++k)
            corners[k] = snapped(transform, mesh.positions[3 * i + k]);
        if (covered(corners, sides).empty())
            continue;
        ++count.drawn;
        EXPECT_TRUE(kept.contains(i)) << "triangle " << i << " is drawn";
    }
    return count;
}

constexpr std::array kAllSides = {VisibleSides::both, VisibleSides::counterClockwise, VisibleSides::clockwise};

TEST(VisibleTriangles, AreAllThatADeviceDraws)
{
    for (const auto kind : {Camera::Kind::perspective, Camera::Kind::orthographic})
        for (const VisibleSides sides : kAllSides)
            for (const double size : {0.002, 0.01, 0.03, 0.3, 1.0}) { // from a tenth of a pixel to half the picture
                const Mesh mesh = randomTriangles(size < 0.01 ? 40000 : 4000, size, 11);
                const Count count = expectNoneLost(mesh, transformOf(cameraAt(5.0, kind)), sides);
                EXPECT_GT(count.drawn, 5) << size;
            }
}

// A corner that the grid moves onto a pixel's centre, which it just misses.
TEST(VisibleTriangles, HoldWhatTheGridMovesIntoThem)
{
    VertexTransform transform = {.clipFromEye = mat4(1.0f), .linear = mat3(1.0f), .translation = vec3(0.0f)};
    transform.clipFromEye[0].x = 2.0f / float(kPixels.x); // one to a pixel, from the picture's middle
    transform.clipFromEye[1].y = 2.0f / float(kPixels.y);
    const auto mesh = [](float tip) {
        Mesh m = {.positions = {vec3(tip, 0.5f, 0.0f), vec3(-0.4f, 0.6f, 0.0f), vec3(-0.4f, 0.4f, 0.0f)},
                  .indices = {0, 1, 2},
                  .box = {}};
        for (const vec3& p : m.positions)
            m.box.include(dvec3(p));
        return m;
    };
    EXPECT_EQ(expectNoneLost(mesh(0.5f - 0.49f / 256.0f), transform, VisibleSides::both).drawn, 1);
    EXPECT_EQ(expectNoneLost(mesh(0.5f - 4.0f / 256.0f), transform, VisibleSides::both).kept, 0);
}

// Most triangles lie beside the picture, some on its border.
TEST(VisibleTriangles, EndAtThePicture)
{
    const Mesh mesh = randomTriangles(20000, 0.05, 5);
    VertexTransform transform = transformOf(cameraAt(5.0));
    transform.translation += vec3(2.0f, 0.3f, 0.0f);
    const Count count = expectNoneLost(mesh, transform, VisibleSides::both);
    EXPECT_GT(count.drawn, 100);
    EXPECT_LT(count.kept, count.all / 2);
}

// The doubt is a step of the grid and a little more, 0.006 pixels: a triangle of sides of half a pixel is kept in
// vain in one of a hundred places.
TEST(VisibleTriangles, AreLittleMoreThanThose)
{
    for (const VisibleSides sides : kAllSides)
        for (const double size : {0.004, 0.01}) {
            const Mesh mesh = randomTriangles(20000, size, 3);
            const Count count = expectNoneLost(mesh, transformOf(cameraAt(5.0)), sides);
            EXPECT_LT(count.kept - count.drawn, 0.05 * (count.all - count.drawn)) << size;
        }
}

// Of a sphere of more triangles than pixels, each pixel shows one. Those are kept, too, that hold a pixel's centre only
// in their hem of the doubt: with 35 fronts to a pixel, of sides of a quarter of a pixel, a quarter as many, and more
// where they are seen edge on.
TEST(VisibleTriangles, OfAFineSphereAreNotMoreThanItsPixels)
{
    const Primitive sphere = sphereMesh();
    const Camera camera = cameraAt(8.0);
    const auto view = triangleView(transformOf(camera), {sphere.boundsMin, sphere.boundsMax}, kPixels,
                                   VisibleSides::counterClockwise, kSubpixelBits);
    ASSERT_TRUE(view);
    std::vector<vec2> places(sphere.positions.size());
    placeVertices(*view, sphere.positions, places);
    std::vector<std::uint32_t> kept(sphere.indices.size());
    const std::size_t triangles = keepVisible(*view, sphere.indices, places, kept.data()) / 3;
    int pixels = 0;
    for (int y = 0; y < kPixels.y; ++y)
        for (int x = 0; x < kPixels.x; ++x) {
            const Ray ray = primaryRay(camera, kPixels.x, kPixels.y, x + 0.5, y + 0.5);
            const dvec3 d = glm::normalize(ray.direction), e = cameraPosition(camera);
            const double b = glm::dot(e, d);
            pixels += b < 0.0 && b * b - glm::dot(e, e) + 1.0 > 0.0;
        }
    EXPECT_GT(sphere.indices.size() / 3, 50 * std::size_t(pixels)) << "the test's own condition";
    EXPECT_GT(triangles, 0.95 * pixels);
    EXPECT_LT(triangles, 1.6 * pixels);
}

TEST(VisibleTriangles, AreTheSameWithoutWideVectors)
{
    if (!processorHasAvx2())
        GTEST_SKIP() << "the processor has none";
    for (const VisibleSides sides : kAllSides)
        for (const double size : {0.01, 0.3}) {
            const Mesh mesh = randomTriangles(3001, size, 17); // not a multiple of the lanes
            const auto view = triangleView(transformOf(cameraAt(4.0)), mesh.box, kPixels, sides, kSubpixelBits);
            ASSERT_TRUE(view);
            EXPECT_EQ(keptOf(mesh, *view, true), keptOf(mesh, *view, false));
        }
}

TEST(VisibleTriangles, TurnRoundWithAMirror)
{
    const Mesh mesh = randomTriangles(500, 0.3, 23);
    const auto keptWith = [&](const dmat3& linear, VisibleSides sides) {
        const auto view = triangleView(transformOf(cameraAt(6.0), linear), mesh.box, kPixels, sides, kSubpixelBits);
        EXPECT_TRUE(view);
        return keptOf(mesh, *view).size();
    };
    // The mirror image of a triangle shows its other side where the mirror lies in the line of sight.
    const std::size_t fronts = keptWith(dmat3(1.0), VisibleSides::counterClockwise);
    const std::size_t backs = keptWith(dmat3(1.0), VisibleSides::clockwise);
    const std::size_t both = keptWith(dmat3(1.0), VisibleSides::both);
    EXPECT_GE(fronts + backs, both);
    EXPECT_LT(fronts + backs, both + both / 10) << "but for those seen edge on";
    EXPECT_EQ(expectNoneLost(mesh, transformOf(cameraAt(6.0), dmat3(-1.0)), VisibleSides::clockwise).all, 500);
}

TEST(VisibleTriangles, VerticesWithoutAPlaceAreKept)
{
    Mesh mesh = randomTriangles(64, 0.001, 29); // all but a few show nowhere
    const auto view = triangleView(transformOf(cameraAt(6.0)), mesh.box, kPixels, VisibleSides::both, kSubpixelBits);
    ASSERT_TRUE(view);
    const std::size_t before = keptOf(mesh, *view).size();
    ASSERT_LT(before, 16u);
    for (const std::uint32_t corner : {0, 1, 2}) {
        mesh.positions[3 * (40 + corner) + corner] = vec3(std::numeric_limits<float>::quiet_NaN());
        mesh.positions[3 * (50 + corner) + corner] = vec3(1e30f, 0.0f, 0.0f); // and not in the box
    }
    const std::set<std::uint32_t> kept = keptOf(mesh, *view);
    for (const std::uint32_t corner : {0, 1, 2}) {
        EXPECT_TRUE(kept.contains(40 + corner)) << corner;
        EXPECT_TRUE(kept.contains(50 + corner)) << corner;
    }
}

TEST(VisibleTriangles, NeedABoxBeforeTheEyeAndPlacesThatAreSure)
{
    const Mesh mesh = randomTriangles(10, 0.1, 31);
    const auto view = [&](const VertexTransform& t, const ivec2& pixels = kPixels) {
        return triangleView(t, mesh.box, pixels, VisibleSides::both, kSubpixelBits);
    };
    EXPECT_TRUE(view(transformOf(cameraAt(5.0))));
    EXPECT_FALSE(view(transformOf(cameraAt(0.5)))) << "from within the box";
    // A metre in a thousand kilometres, seen from as far: floats place it to 6 cm, a thirtieth of the picture.
    Camera far = cameraAt(1e6);
    far.verticalFov = 2e-6;
    far.farPlane = 1e7;
    EXPECT_FALSE(view(transformOf(far)));
    EXPECT_TRUE(view(transformOf(cameraAt(5.0)), ivec2(16384)));
}

} // namespace
} // namespace torrance
