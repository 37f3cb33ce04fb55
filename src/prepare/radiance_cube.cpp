#include "prepare/radiance_cube.h"

#include "core/parallel.h"
#include "math/cube.h"
#include "math/latlong.h"
#include "prepare/cube_levels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

namespace torrance {
namespace {

/// Texels brighter than this many robust means are suns and lamps.
constexpr float kExcessFactor = 16.0f;
/// Each excess texel is deposited as this many by this many points.
constexpr int kDepositGrid = 8;
/// Sub-texels along each side of a cube texel at which the base is read.
constexpr int kGatherGrid = 2;

float brightest(const float* rgb)
{
    return std::max({rgb[0], rgb[1], rgb[2]});
}

/// Mean over the sphere of the brightest channel, no texel counting more than `limit`.
double meanBelow(const Image& panorama, float limit)
{
    std::vector<double> rows(static_cast<std::size_t>(panorama.height));
    parallelFor(rows.size(), 16, [&](std::size_t y) {
        double sum = 0.0;
        for (int x = 0; x < panorama.width; ++x)
            sum += std::min(brightest(panorama.at(x, static_cast<int>(y))), limit);
        rows[y] = sum * latLongTexelSolidAngle(static_cast<int>(y), panorama.width, panorama.height);
    });
    double total = 0.0;
    for (const double row : rows)
        total += row;
    return total / (4.0 * kPi);
}

/// kExcessFactor times a mean that suns do not lift: limit and mean are taken from each other until they agree.
float excessThreshold(const Image& panorama)
{
    constexpr int kRounds =
        40; // each round lowers a sun's share of the mean about kExcessFactor * its area / (4 pi) times
    double limit = HUGE_VAL;
    for (int i = 0; i < kRounds; ++i) {
        const double next = kExcessFactor * meanBelow(panorama, static_cast<float>(limit));
        const bool settled = next > 0.99 * limit;
        limit = next;
        if (settled)
            break;
    }
    return static_cast<float>(limit);
}

/// The factor that brings a texel down to the threshold.
float baseShare(const float* rgb, float threshold)
{
    const float value = brightest(rgb);
    return value > threshold ? threshold / value : 1.0f;
}

/// Three channels and one that counts for nothing.
using Color = float __attribute__((vector_size(4 * sizeof(float))));

/// The panorama below the threshold, averaged over factor x factor texels by their solid angle. Sides that the factor
/// does not divide lose nothing: the last texels cover fewer.
struct BaseImage
{
    int width;
    int height;
    std::vector<float> texels; // of three channels, and one float more: they are read as four

    Color at(int x, int y) const
    {
        Color color;
        std::memcpy(&color,
                    texels.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                         static_cast<std::size_t>(x)),
                    sizeof color);
        return color;
    }
};

void setMean(const Image& panorama, float threshold, int factor, int x, int y, float* out)
{
    vec3 sum(0.0f);
    float weights = 0.0f;
    for (int j = y * factor; j < std::min((y + 1) * factor, panorama.height); ++j) {
        const auto weight = static_cast<float>(latLongTexelSolidAngle(j, panorama.width, panorama.height));
        for (int i = x * factor; i < std::min((x + 1) * factor, panorama.width); ++i) {
            const float* rgb = panorama.at(i, j);
            sum += weight * baseShare(rgb, threshold) * vec3(rgb[0], rgb[1], rgb[2]);
            weights += weight;
        }
    }
    for (int c = 0; c < 3; ++c)
        out[c] = sum[c] / weights;
}

void setShare(const float* rgb, float threshold, float* out)
{
    const float share = baseShare(rgb, threshold);
    for (int c = 0; c < 3; ++c)
        out[c] = share * rgb[c];
}

BaseImage makeBaseImage(const Image& panorama, float threshold, int factor)
{
    BaseImage base{(panorama.width + factor - 1) / factor, (panorama.height + factor - 1) / factor, {}};
    const auto width = static_cast<std::size_t>(base.width);
    base.texels.resize(3 * width * static_cast<std::size_t>(base.height) + 1);
    parallelFor(static_cast<std::size_t>(base.height), 16, [&](std::size_t row) {
        float* out = base.texels.data() + 3 * row * width;
        for (int x = 0; x < base.width; ++x, out += 3) {
            const int y = static_cast<int>(row);
            factor == 1 ? setShare(panorama.at(x, y), threshold, out) : setMean(panorama, threshold, factor, x, y, out);
        }
    });
    return base;
}

/// A place between two columns or rows of the base image.
struct Between
{
    int first, second;
    float share; // of the second

    static Between columns(float u, int width) // periodic
    {
        const float x = u * static_cast<float>(width) - 0.5f, column = std::floor(x);
        int x0 = static_cast<int>(column);
        x0 = x0 < 0 ? x0 + width : x0 >= width ? x0 - width : x0;
        return {x0, x0 + 1 == width ? 0 : x0 + 1, x - column};
    }
    static Between rows(float v, int height)
    {
        const float y = std::clamp(v * static_cast<float>(height) - 0.5f, 0.0f, static_cast<float>(height - 1));
        const int y0 = static_cast<int>(y);
        return {y0, std::min(y0 + 1, height - 1), y - static_cast<float>(y0)};
    }
};

Color bilinear(const BaseImage& base, const Between& x, const Between& y)
{
    const Color upper = base.at(x.first, y.first), lower = base.at(x.first, y.second);
    return (upper + (base.at(x.second, y.first) - upper) * x.share) * (1.0f - y.share) +
           (lower + (base.at(x.second, y.second) - lower) * x.share) * y.share;
}

/// Fills the base's part of a cube: a row of texels of each face, and the row as far from the other edge. Faces are
/// alike but for turns and mirrors, and so are the four quarters of a face: angles are computed for one.
class BaseGather
{
public:
    BaseGather(const BaseImage& image, RadianceCube& target) : base(image), cube(target), sideColumns(makeSideColumns())
    {
    }

    void rows(int fromEdge)
    {
        const int n = cube.size;
        const Quarter quarter(n, fromEdge);
        for (const int y : {fromEdge, n - 1 - fromEdge})
            for (int x = 0; x < n; ++x)
                texels(quarter, x, y);
    }

private:
    static constexpr int kSamples = kGatherGrid * kGatherGrid;

    /// Of one row of texels of the quarter a < 0, b < 0 of a face, by distance from the edges: sub-texels by their |a|,
    /// and texels.
    struct Quarter
    {
        struct Sub
        {
            double sidePolar; // between the axis +Y and the direction on a side face whose b is negative
            double capPolar;  // on the face +Y
            double capTurn;   // of the place on a cap about its middle, from the axis a
            float weight;     // solid angle per area of the face
        };
        struct Texel
        {
            double inverseLength; // of cubeVector to the texel's middle
            float solidAngle;
        };
        std::array<std::vector<Sub>, kGatherGrid> sub;
        std::vector<Texel> texel;

        Quarter(int size, int row)
        {
            const int count = size / 2;
            const auto edge = [&](int i) { return std::abs(2.0 * i / size - 1.0); };
            const auto middle = [&](int i, int parts) { return std::abs(2.0 * (i + 0.5) / (parts * size) - 1.0); };
            for (int j = 0; j < kGatherGrid; ++j)
                for (int i = 0; i < kGatherGrid * count; ++i) {
                    const double a = middle(i, kGatherGrid), b = middle(kGatherGrid * row + j, kGatherGrid);
                    const double squared = 1.0 + a * a + b * b;
                    sub[static_cast<std::size_t>(j)].push_back(
                        {.sidePolar = std::atan2(std::sqrt(1.0 + a * a), b),
                         .capPolar = std::atan2(std::sqrt(a * a + b * b), 1.0),
                         .capTurn = std::atan2(b, a),
                         .weight = static_cast<float>(1.0 / (squared * std::sqrt(squared)))});
                }
            // As cubeRectangleSolidAngle, whose corners are shared.
            std::vector<double> outer, inner;
            for (int i = 0; i <= count; ++i)
                for (auto* corners : {&outer, &inner}) {
                    const double a = edge(i), b = edge(corners == &outer ? row : row + 1);
                    corners->push_back(std::atan2(a * b, std::sqrt(1.0 + a * a + b * b)));
                }
            for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
                const double a = middle(static_cast<int>(i), 1), b = middle(row, 1);
                texel.push_back(
                    {.inverseLength = 1.0 / std::sqrt(1.0 + a * a + b * b),
                     .solidAngle = static_cast<float>((outer[i] - outer[i + 1]) - (inner[i] - inner[i + 1]))});
            }
        }
    };

    /// Columns of the base image that the sub-texels of the side faces +X, +Z, -X and -Z see: they depend on a alone.
    std::array<std::vector<Between>, 4> makeSideColumns() const
    {
        std::array<std::vector<Between>, 4> columns;
        const int count = kGatherGrid * cube.size;
        for (int i = 0; i < count; ++i) {
            const double a = 2.0 * (i + 0.5) / count - 1.0;
            const auto u = static_cast<float>(0.5 + std::atan2(-a, 1.0) / (2.0 * kPi)); // on +X
            for (std::size_t face = 0; face < 4; ++face)
                columns[face].push_back(
                    Between::columns(wrapped(u + std::array{0.0f, 0.25f, 0.5f, -0.25f}[face]), base.width));
        }
        return columns;
    }

    static float wrapped(float u) { return u < 0.0f ? u + 1.0f : u >= 1.0f ? u - 1.0f : u; }

    /// The texel (x, y) of all six faces.
    void texels(const Quarter& quarter, int x, int y)
    {
        const int n = cube.size, parts = kGatherGrid;
        std::array<Color, kCubeFaces> mean = {};
        float weights = 0.0f;
        for (int s = 0; s < kSamples; ++s) {
            const int i = parts * x + s % parts, j = parts * y + s / parts; // of the face's sub-texels
            const bool right = i >= n * parts / 2, below = j >= n * parts / 2;
            const auto fromEdge = [&](int k, bool far) { return far ? n * parts - 1 - k : k; };
            const Quarter::Sub& sub = quarter.sub[static_cast<std::size_t>(fromEdge(j, below) % parts)]
                                                 [static_cast<std::size_t>(fromEdge(i, right))];
            weights += sub.weight;
            addSides(sub, i, below, mean);
            addCaps(sub, right, below, mean);
        }
        const Quarter::Texel& texel = quarter.texel[static_cast<std::size_t>(std::min(x, n - 1 - x))];
        for (int face = 0; face < kCubeFaces; ++face)
            put(face, x, y, texel, mean[static_cast<std::size_t>(face)] / weights);
    }

    void addSides(const Quarter::Sub& sub, int i, bool below, std::array<Color, kCubeFaces>& mean) const
    {
        const double polar = below ? kPi - sub.sidePolar : sub.sidePolar;
        const Between row = Between::rows(static_cast<float>(polar / kPi), base.height);
        for (std::size_t side = 0; side < 4; ++side)
            mean[std::array<std::size_t, 4>{0, 4, 1, 5}[side]] +=
                sub.weight * bilinear(base, sideColumns[side][static_cast<std::size_t>(i)], row);
    }

    /// The face -Y is the other mirrored, u to 1 - u and v to 1 - v.
    void addCaps(const Quarter::Sub& sub, bool right, bool below, std::array<Color, kCubeFaces>& mean) const
    {
        const double turn = right ? sub.capTurn : kPi - sub.capTurn;
        const auto u = static_cast<float>(0.5 + (below ? turn : -turn) / (2.0 * kPi));
        const auto v = static_cast<float>(sub.capPolar / kPi);
        mean[2] += sub.weight * bilinear(base, Between::columns(u, base.width), Between::rows(v, base.height));
        mean[3] +=
            sub.weight * bilinear(base, Between::columns(1.0f - u, base.width), Between::rows(1.0f - v, base.height));
    }

    void put(int face, int x, int y, const Quarter::Texel& texel, const Color& mean)
    {
        const std::uint32_t code = treeCode(face, x, y, cube.size);
        const dvec3 direction =
            cubeVector(face, cubeTexelCentre(x, cube.size), cubeTexelCentre(y, cube.size)) * texel.inverseLength;
        cube.base.codes[code] = code;
        // The spread of a square of that area.
        cube.base.nodes[code] = {vec3(direction), 0.5f * std::sqrt(texel.solidAngle), texel.solidAngle,
                                 vec3(mean[0], mean[1], mean[2]) * texel.solidAngle};
        float* out = cube.radiance.data() + 4 * cubeTexelIndex(face, x, y, cube.size);
        out[0] = mean[0], out[1] = mean[1], out[2] = mean[2], out[3] = 1.0f;
    }

    const BaseImage& base;
    RadianceCube& cube;
    std::array<std::vector<Between>, 4> sideColumns;
};

/// Sums per texel of the cube that something reaches. Points that are integrated go where they are; what is seen is
/// spread over the four texels around (of the same face), so that a lamp has no moire of points.
class Deposit
{
public:
    struct Sums
    {
        std::size_t texel;
        dvec3 energy{0.0}, moment{0.0}; // moment: directions weighted by the energy of all channels
        dvec3 seen{0.0};                // energy
    };

    explicit Deposit(int cubeSize) : size(cubeSize), slots(cubeTexelIndex(kCubeFaces, 0, 0, cubeSize), kNone) {}

    void add(const dvec3& d, const dvec3& energy)
    {
        const CubePoint p = cubePoint(d);
        const double x = std::clamp((p.a + 1.0) * 0.5 * size, 0.0, size - 1e-9),
                     y = std::clamp((p.b + 1.0) * 0.5 * size, 0.0, size - 1e-9);
        Sums& own = at(p.face, static_cast<int>(x), static_cast<int>(y));
        own.energy += energy;
        own.moment += (energy.r + energy.g + energy.b) * d;

        const double left = std::clamp(x - 0.5, 0.0, size - 1.0), above = std::clamp(y - 0.5, 0.0, size - 1.0);
        const int x0 = std::min(static_cast<int>(left), size - 2), y0 = std::min(static_cast<int>(above), size - 2);
        const double fx = left - x0, fy = above - y0;
        at(p.face, x0, y0).seen += (1.0 - fx) * (1.0 - fy) * energy;
        at(p.face, x0 + 1, y0).seen += fx * (1.0 - fy) * energy;
        at(p.face, x0, y0 + 1).seen += (1.0 - fx) * fy * energy;
        at(p.face, x0 + 1, y0 + 1).seen += fx * fy * energy;
    }

    /// By rising tree code.
    std::vector<std::pair<std::uint32_t, Sums>> sorted() const
    {
        std::vector<std::pair<std::uint32_t, Sums>> list;
        const auto n = static_cast<std::size_t>(size);
        for (const Sums& s : sums) {
            const auto face = static_cast<int>(s.texel / (n * n));
            list.emplace_back(treeCode(face, static_cast<int>(s.texel % n), static_cast<int>(s.texel / n % n), size),
                              s);
        }
        std::ranges::sort(list, {}, [](const auto& entry) { return entry.first; });
        return list;
    }

private:
    Sums& at(int face, int x, int y)
    {
        const std::size_t texel = cubeTexelIndex(face, x, y, size);
        std::uint32_t& slot = slots[texel];
        if (slot == kNone) {
            slot = static_cast<std::uint32_t>(sums.size());
            sums.push_back({.texel = texel});
        }
        return sums[slot];
    }

    static constexpr std::uint32_t kNone = ~0u;
    int size;
    std::vector<std::uint32_t> slots; // by texel
    std::vector<Sums> sums;
};

/// What one bright texel holds above the threshold, as points of equal share of its area.
void depositTexel(const Image& panorama, int x, int y, const dvec3& radiance, Deposit& deposit)
{
    const int columns = panorama.width * kDepositGrid, rows = panorama.height * kDepositGrid;
    std::array<dvec2, kDepositGrid> azimuths; // cosine, sine
    for (int i = 0; i < kDepositGrid; ++i) {
        const double phi = 2.0 * kPi * ((x * kDepositGrid + i + 0.5) / columns - 0.5);
        azimuths[static_cast<std::size_t>(i)] = {std::cos(phi), std::sin(phi)};
    }
    for (int j = 0; j < kDepositGrid; ++j) {
        const int row = y * kDepositGrid + j;
        const double theta = kPi * ((row + 0.5) / rows), sine = std::sin(theta), cosine = std::cos(theta);
        const dvec3 energy = radiance * latLongTexelSolidAngle(row, columns, rows);
        for (const dvec2& azimuth : azimuths)
            deposit.add({sine * azimuth.x, cosine, sine * azimuth.y}, energy);
    }
}

/// One after the other: the order of the sums is part of the result.
void depositExcess(const Image& panorama, float threshold, RadianceCube& cube)
{
    Deposit deposit(cube.size);
    for (int y = 0; y < panorama.height; ++y)
        for (int x = 0; x < panorama.width; ++x) {
            const float* rgb = panorama.at(x, y);
            const float share = baseShare(rgb, threshold);
            if (share < 1.0f)
                depositTexel(panorama, x, y, (1.0 - static_cast<double>(share)) * dvec3(rgb[0], rgb[1], rgb[2]),
                             deposit);
        }
    for (const auto& [code, sums] : deposit.sorted()) {
        const float solidAngle = cube.base.nodes[code].solidAngle;
        const double light = sums.energy.r + sums.energy.g + sums.energy.b;
        if (light > 0.0) {
            cube.excess.codes.push_back(code);
            cube.excess.nodes.push_back(makeCubeNode(sums.moment / light, solidAngle, vec3(sums.energy)));
        }
        for (int c = 0; c < 3; ++c)
            cube.radiance[4 * sums.texel + static_cast<std::size_t>(c)] +=
                static_cast<float>(sums.seen[c] / static_cast<double>(solidAngle));
    }
}

} // namespace

RadianceCube makeRadianceCube(const Image& panorama, int size)
{
    RadianceCube cube;
    cube.size = size;
    const std::size_t texels = cubeTexelIndex(kCubeFaces, 0, 0, size);
    cube.base.codes.resize(texels);
    cube.base.nodes.resize(texels);
    cube.radiance.resize(4 * texels);

    const float threshold = excessThreshold(panorama);
    const int factor =
        std::max(1, panorama.width / (4 * size)); // so that a sub-texel of the cube skips no texel of the source
    const BaseImage base = makeBaseImage(panorama, threshold, factor);
    BaseGather gather(base, cube);
    parallelFor(static_cast<std::size_t>(size / 2), 2, [&](std::size_t row) { gather.rows(static_cast<int>(row)); });
    depositExcess(panorama, threshold, cube);
    return cube;
}

} // namespace torrance
