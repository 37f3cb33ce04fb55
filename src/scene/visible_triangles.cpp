#include "scene/visible_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace torrance {
namespace {

constexpr double kUnit = 0x1p-24; // of rounding to float
/// Roundings on the way of a coordinate, of the device and here together, each at most kUnit of the largest sum on it:
/// three products, three sums and two inputs to the eye, four and four to the clip space, and as many here.
constexpr double kRoundings = 32.0;
/// Vertices further beside the picture than this many times its half are not placed: rounding grows with the distance.
constexpr float kBeside = 4.0f;
/// Where more than this much of a pixel is in doubt, the tests would leave out too little to pay for themselves.
constexpr double kMostDoubt = 0.25;
/// Triangles over more columns or rows of centres than this are kept: they are drawn for their pixels, not for
/// themselves.
constexpr int kMostColumns = 2;

// Eight triangles' corners: x and y of each by lanes.
struct Corners
{
    Lanes x[3], y[3];
};

TORRANCE_INLINE Lanes magnitude(const Lanes& a)
{
    return a < 0.0f ? -a : a;
}

TORRANCE_INLINE Lanes lesser(const Lanes& a, const Lanes& b)
{
    return a < b ? a : b;
}

TORRANCE_INLINE Lanes greater(const Lanes& a, const Lanes& b)
{
    return a < b ? b : a;
}

// The floor of what is not negative.
TORRANCE_INLINE IntLanes whole(const Lanes& a)
{
    return __builtin_convertvector(a, IntLanes);
}

// The product ab x ac of points that are each off by (d, d) at most is off by d (|ab| + |bc| + |ca|) + 8 d^2 at most,
// the norms those of sums: what moves a, say, moves the product by that times bc. Where one of the points is sure, this
// leaves its part for the rounding here.
TORRANCE_INLINE Lanes productDoubt(const Lanes& norms, float doubt)
{
    return doubt * norms + 8.0f * doubt * doubt;
}

TORRANCE_INLINE Lanes norm(const Lanes& x, const Lanes& y)
{
    return magnitude(x) + magnitude(y);
}

// Whether a point may lie in the triangles, whose areas have these signs.
TORRANCE_INLINE IntLanes mayHold(const Corners& corners, const Lanes& sign, const Lanes& x, const Lanes& y, float doubt)
{
    Lanes toX[3], toY[3], norms[3]; // from the point to the corners
    for (int i = 0; i < 3; ++i) {
        toX[i] = corners.x[i] - x;
        toY[i] = corners.y[i] - y;
        norms[i] = norm(toX[i], toY[i]);
    }
    IntLanes may = ~IntLanes{};
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const Lanes inside = sign * (toX[i] * toY[j] - toY[i] * toX[j]);
        may &= inside >= -productDoubt(norms[i] + norms[j], doubt);
    }
    return may;
}

TORRANCE_INLINE bool any(const IntLanes& lanes)
{
    std::array<std::int64_t, kLanes / 2> halves;
    std::memcpy(halves.data(), &lanes, sizeof lanes);
    return (halves[0] | halves[1] | halves[2] | halves[3]) != 0;
}

// All bits where a triangle may show.
TORRANCE_INLINE IntLanes mayShow(const TriangleView& view, const Corners& c)
{
    const float doubt = view.doubt;
    const Lanes abX = c.x[1] - c.x[0], abY = c.y[1] - c.y[0], acX = c.x[2] - c.x[0], acY = c.y[2] - c.y[0];
    const Lanes area = abX * acY - abY * acX; // twice; y is down: above 0 where corners run clockwise
    const Lanes areaDoubt = productDoubt(norm(abX, abY) + norm(acX, acY) + norm(acX - abX, acY - abY), doubt);
    const IntLanes unplaced = area != area;
    IntLanes shows = ~IntLanes{};
    if (view.sides != VisibleSides::both)
        shows = (view.sides == VisibleSides::clockwise ? area : -area) >= -areaDoubt;

    // The first and the last pixel whose centre lies in the box: where none does, the last comes before the first.
    const Lanes nothing = {}; // before the other number: what is no number is not taken then
    const Lanes left = greater(nothing, lesser(c.x[0], lesser(c.x[1], c.x[2])) - doubt);
    const Lanes top = greater(nothing, lesser(c.y[0], lesser(c.y[1], c.y[2])) - doubt);
    const Lanes right = lesser(greater(c.x[0], greater(c.x[1], c.x[2])) + doubt, nothing + 2.0f * view.halfSize.x);
    const Lanes bottom = lesser(greater(c.y[0], greater(c.y[1], c.y[2])) + doubt, nothing + 2.0f * view.halfSize.y);
    const IntLanes column = whole(left + 0.5f), row = whole(top + 0.5f);
    const IntLanes columns = whole(greater(right + 0.5f, nothing)) - column;
    const IntLanes rows = whole(greater(bottom + 0.5f, nothing)) - row;
    shows &= (columns > 0) & (rows > 0);

    const IntLanes plain = (columns > kMostColumns) | (rows > kMostColumns) | (magnitude(area) <= areaDoubt);
    if (any(shows & ~plain)) {
        const Lanes sign = area > 0.0f ? nothing + 1.0f : nothing - 1.0f;
        const Lanes x = __builtin_convertvector(column, Lanes) + 0.5f, y = __builtin_convertvector(row, Lanes) + 0.5f;
        IntLanes covers = plain;
        for (int v = 0; v < kMostColumns; ++v)
            for (int u = 0; u < kMostColumns; ++u) // beyond a box's last, no triangle holds it
                covers |= mayHold(c, sign, x + float(u), y + float(v), doubt);
        shows &= covers;
    }
    return shows | unplaced;
}

// Those of `count` triangles at most kLanes: 1 where one may show.
TORRANCE_INLINE void shown(const TriangleView& view, const std::uint32_t* indices, std::size_t count,
                           const vec2* places, std::array<std::uint32_t, kLanes>& flags)
{
    std::array<std::array<float, kLanes>, 3> x = {}, y = {}; // of none: points in the picture's corner
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const vec2& place = places[indices[3 * i + corner]];
            x[corner][i] = place.x;
            y[corner][i] = place.y;
        }
    Corners corners;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        load(corners.x[corner], x[corner].data());
        load(corners.y[corner], y[corner].data());
    }
    const IntLanes lanes = mayShow(view, corners) & 1;
    std::memcpy(flags.data(), &lanes, sizeof lanes);
}

TORRANCE_INLINE std::size_t keepVisibleIn(const TriangleView& view, std::span<const std::uint32_t> indices,
                                          std::span<const vec2> places, std::uint32_t* kept)
{
    std::uint32_t* next = kept;
    const std::size_t triangles = indices.size() / 3;
    for (std::size_t first = 0; first < triangles; first += kLanes) {
        const std::uint32_t* const from = indices.data() + 3 * first;
        const std::size_t count = std::min<std::size_t>(kLanes, triangles - first);
        std::array<std::uint32_t, kLanes> flags;
        count == kLanes ? shown(view, from, kLanes, places.data(), flags)
                        : shown(view, from, count, places.data(), flags);
        for (std::size_t i = 0; i < count; ++i) {
            // Written whether or not it stays: whether it does is a coin's toss, which no processor foresees.
            std::copy_n(from + 3 * i, 3, next);
            next += 3 * flags[i];
        }
    }
    return static_cast<std::size_t>(next - kept);
}

TORRANCE_AVX2 std::size_t keepVisibleAvx2(const TriangleView& view, std::span<const std::uint32_t> indices,
                                          std::span<const vec2> places, std::uint32_t* kept)
{
    return keepVisibleIn(view, indices, places, kept);
}

} // namespace

std::optional<TriangleView> triangleView(const VertexTransform& transform, const Box& box, const ivec2& pixels,
                                         VisibleSides sides, unsigned subpixelBits)
{
    const dmat4 clipFromEye(transform.clipFromEye);
    const dmat3 linear(transform.linear);
    const dvec3 translation(transform.translation);
    dmat4 eyeFromObject = dmat4(linear);
    eyeFromObject[3] = dvec4(translation, 1.0);
    const dmat4 clipFromObject = clipFromEye * eyeFromObject;

    // The largest sum that a coordinate may come from, all terms of one sign.
    const dvec3 reach = glm::max(glm::abs(box.least), glm::abs(box.greatest));
    dvec3 eye = glm::abs(translation);
    for (int j = 0; j < 3; ++j)
        eye += glm::abs(linear[j]) * reach[j];
    dvec4 sum = glm::abs(clipFromEye[3]);
    for (int i = 0; i < 3; ++i)
        sum += glm::abs(clipFromEye[i]) * eye[i];
    const dvec4 rounding = kRoundings * kUnit * sum;

    double leastW = std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8; ++corner)
        leastW = std::min(leastW, (clipFromObject * dvec4(box.corner(corner), 1.0)).w);
    leastW -= rounding.w;
    if (!(leastW > 0.0))
        return std::nullopt;
    const dvec2 half = 0.5 * dvec2(pixels);
    const dvec2 placed = half * (dvec2(rounding) + kBeside * rounding.w) / leastW;
    const double most = std::max(placed.x, placed.y) +
                        kRoundings * kUnit * kBeside * std::max(half.x, half.y) + // division, and to pixels
                        std::exp2(-double(subpixelBits));                         // to the grid, whichever way
    if (!(most <= kMostDoubt))
        return std::nullopt;
    return TriangleView{.clipFromObject = mat4(clipFromObject),
                        .halfSize = vec2(half),
                        .sides = sides,
                        .leastW = static_cast<float>(leastW),
                        .doubt = static_cast<float>(most)};
}

void placeVertices(const TriangleView& view, std::span<const vec3> positions, std::span<vec2> places)
{
    constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
    const mat4& m = view.clipFromObject;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const vec3& p = positions[i];
        const float x = m[0].x * p.x + m[1].x * p.y + m[2].x * p.z + m[3].x;
        const float y = m[0].y * p.x + m[1].y * p.y + m[2].y * p.z + m[3].y;
        const float w = m[0].w * p.x + m[1].w * p.y + m[2].w * p.z + m[3].w;
        const bool known = w >= view.leastW && std::abs(x) <= kBeside * w && std::abs(y) <= kBeside * w;
        const float scale = known ? 1.0f / w : kNowhere;
        places[i] = (vec2(x, y) * scale + 1.0f) * view.halfSize;
    }
}

std::size_t keepVisible(const TriangleView& view, std::span<const std::uint32_t> indices, std::span<const vec2> places,
                        std::uint32_t* kept, bool avx2)
{
    return avx2 ? keepVisibleAvx2(view, indices, places, kept) : keepVisibleIn(view, indices, places, kept);
}

} // namespace torrance
