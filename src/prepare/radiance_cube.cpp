#include "prepare/radiance_cube.h"

#include "core/parallel.h"
#include "math/cube.h"
#include "math/latlong.h"
#include "prepare/cube_levels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
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

/// The panorama below the threshold, averaged over factor x factor texels by their solid angle.
struct BaseImage
{
    int width;
    int height;
    std::vector<vec3> texels;

    /// Bilinear, periodic in u.
    vec3 at(float u, float v) const
    {
        const float x = u * static_cast<float>(width) - 0.5f;
        const float y = std::clamp(v * static_cast<float>(height) - 0.5f, 0.0f, static_cast<float>(height - 1));
        const float column = std::floor(x), row = std::floor(y);
        const float fx = x - column, fy = y - row;
        int x0 = static_cast<int>(column);
        x0 = x0 < 0 ? x0 + width : x0 >= width ? x0 - width : x0;
        const int x1 = x0 + 1 == width ? 0 : x0 + 1;
        const int y0 = static_cast<int>(row), y1 = std::min(y0 + 1, height - 1);
        const vec3* upper = texels.data() + static_cast<std::size_t>(y0) * static_cast<std::size_t>(width);
        const vec3* lower = texels.data() + static_cast<std::size_t>(y1) * static_cast<std::size_t>(width);
        return (upper[x0] + (upper[x1] - upper[x0]) * fx) * (1.0f - fy) +
               (lower[x0] + (lower[x1] - lower[x0]) * fx) * fy;
    }
};

/// One row of the base image. Sides that the factor does not divide lose nothing: the last texels cover fewer.
BaseImage makeBaseImage(const Image& panorama, float threshold, int factor)
{
    BaseImage base{(panorama.width + factor - 1) / factor, (panorama.height + factor - 1) / factor, {}};
    base.texels.resize(static_cast<std::size_t>(base.width) * static_cast<std::size_t>(base.height));
    parallelFor(static_cast<std::size_t>(base.height), 16, [&](std::size_t row) {
        for (int x = 0; x < base.width; ++x) {
            vec3 sum(0.0f);
            float weights = 0.0f;
            for (int j = static_cast<int>(row) * factor;
                 j < std::min((static_cast<int>(row) + 1) * factor, panorama.height); ++j) {
                const auto weight = static_cast<float>(latLongTexelSolidAngle(j, panorama.width, panorama.height));
                for (int i = x * factor; i < std::min((x + 1) * factor, panorama.width); ++i) {
                    const float* rgb = panorama.at(i, j);
                    sum += weight * baseShare(rgb, threshold) * vec3(rgb[0], rgb[1], rgb[2]);
                    weights += weight;
                }
            }
            base.texels[row * static_cast<std::size_t>(base.width) + static_cast<std::size_t>(x)] = sum / weights;
        }
    });
    return base;
}

/// Fills one row of the four side faces (alike but for a quarter turn) or of the two caps (mirror images of each
/// other).
class BaseGather
{
public:
    BaseGather(const BaseImage& image, RadianceCube& target) : base(image), cube(target) {}

    void sideRow(int y)
    {
        const int n = cube.size;
        for (int x = 0; x < n; ++x) {
            const Samples s = samplesOf(0, x, y); // +X
            const std::array<std::pair<int, float>, 4> faces = {{{0, 0.0f}, {4, 0.25f}, {1, 0.5f}, {5, -0.25f}}};
            for (const auto& [face, turn] : faces)
                put(face, x, y, s,
                    [&, quarter = turn](const vec2& uv) { return base.at(wrapped(uv.x + quarter), uv.y); });
        }
    }

    void capRow(int y)
    {
        for (int x = 0; x < cube.size; ++x) {
            const Samples s = samplesOf(2, x, y); // +Y
            put(2, x, y, s, [&](const vec2& uv) { return base.at(uv.x, uv.y); });
            put(3, x, y, s, [&](const vec2& uv) { return base.at(1.0f - uv.x, 1.0f - uv.y); });
        }
    }

private:
    struct Samples
    {
        std::array<vec2, kGatherGrid * kGatherGrid> uv;
        std::array<float, kGatherGrid * kGatherGrid> weight; // sum 1
    };

    static float wrapped(float u) { return u < 0.0f ? u + 1.0f : u >= 1.0f ? u - 1.0f : u; }

    Samples samplesOf(int face, int x, int y) const
    {
        Samples s;
        float sum = 0.0f;
        for (std::size_t i = 0; i < s.uv.size(); ++i) {
            const double a = 2.0 * (x + (static_cast<double>(i % kGatherGrid) + 0.5) / kGatherGrid) / cube.size - 1.0;
            const double b = 2.0 * (y + (static_cast<double>(i / kGatherGrid) + 0.5) / kGatherGrid) / cube.size - 1.0;
            s.uv[i] = vec2(latLongFromDirection(cubeVector(face, a, b)));
            const double squared = 1.0 + a * a + b * b;
            s.weight[i] = static_cast<float>(1.0 / (squared * std::sqrt(squared))); // solid angle per area of the face
            sum += s.weight[i];
        }
        for (float& weight : s.weight)
            weight /= sum;
        return s;
    }

    template <typename Read>
    void put(int face, int x, int y, const Samples& s, const Read& read)
    {
        vec3 mean(0.0f);
        for (std::size_t i = 0; i < s.uv.size(); ++i)
            mean += s.weight[i] * read(s.uv[i]);
        CubeNode& node = cube.base[cubeTexelIndex(face, x, y, cube.size)];
        const double variance = node.solidAngle / 6.0; // of a square of that area, both axes together
        node = makeCubeNode(cubeTexelDirection(face, x, y, cube.size) * (1.0 - 0.5 * variance), node.solidAngle,
                            mean * node.solidAngle);
        float* out = cube.radiance.data() + 4 * cubeTexelIndex(face, x, y, cube.size);
        out[0] = mean.r, out[1] = mean.g, out[2] = mean.b, out[3] = 1.0f;
    }

    const BaseImage& base;
    RadianceCube& cube;
};

void setSolidAngles(RadianceCube& cube)
{
    const int n = cube.size;
    parallelFor(static_cast<std::size_t>(n), 8, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < n; ++x) {
            const auto omega = static_cast<float>(cubeTexelSolidAngle(x, y, n));
            for (int face = 0; face < kCubeFaces; ++face) {
                const std::size_t i = cubeTexelIndex(face, x, y, n);
                cube.base[i].solidAngle = cube.excess[i].solidAngle = omega;
            }
        }
    });
}

/// Sums per texel of the cube. Points that are integrated go where they are; what is seen is spread over the four
/// texels around (of the same face), so that a lamp has no moire of points.
struct Deposit
{
    std::vector<dvec3> energy, moment; // moment: directions weighted by the energy of all channels
    std::vector<dvec3> seen;           // energy

    explicit Deposit(std::size_t texels)
        : energy(texels, dvec3(0.0)), moment(texels, dvec3(0.0)), seen(texels, dvec3(0.0))
    {
    }
};

void depositPoint(const dvec3& d, const dvec3& energy, int size, Deposit& deposit)
{
    const CubePoint p = cubePoint(d);
    const double x = std::clamp((p.a + 1.0) * 0.5 * size, 0.0, size - 1e-9),
                 y = std::clamp((p.b + 1.0) * 0.5 * size, 0.0, size - 1e-9);
    const std::size_t index = cubeTexelIndex(p.face, static_cast<int>(x), static_cast<int>(y), size);
    deposit.energy[index] += energy;
    deposit.moment[index] += (energy.r + energy.g + energy.b) * d;

    const double left = std::clamp(x - 0.5, 0.0, size - 1.0), above = std::clamp(y - 0.5, 0.0, size - 1.0);
    const int x0 = std::min(static_cast<int>(left), size - 2), y0 = std::min(static_cast<int>(above), size - 2);
    const double fx = left - x0, fy = above - y0;
    dvec3* corner = deposit.seen.data() + cubeTexelIndex(p.face, x0, y0, size);
    corner[0] += (1.0 - fx) * (1.0 - fy) * energy;
    corner[1] += fx * (1.0 - fy) * energy;
    corner[size] += (1.0 - fx) * fy * energy;
    corner[size + 1] += fx * fy * energy;
}

/// What one bright texel holds above the threshold, as points of equal share of its area.
void depositTexel(const Image& panorama, int x, int y, const dvec3& radiance, int size, Deposit& deposit)
{
    const int columns = panorama.width * kDepositGrid, rows = panorama.height * kDepositGrid;
    for (int j = 0; j < kDepositGrid; ++j)
        for (int i = 0; i < kDepositGrid; ++i) {
            const int row = y * kDepositGrid + j;
            const dvec3 d = directionFromLatLong({(x * kDepositGrid + i + 0.5) / columns, (row + 0.5) / rows});
            depositPoint(d, radiance * latLongTexelSolidAngle(row, columns, rows), size, deposit);
        }
}

/// One after the other: the order of the sums is part of the result.
void depositExcess(const Image& panorama, float threshold, RadianceCube& cube)
{
    Deposit deposit(cube.excess.size());
    for (int y = 0; y < panorama.height; ++y)
        for (int x = 0; x < panorama.width; ++x) {
            const float* rgb = panorama.at(x, y);
            const float share = baseShare(rgb, threshold);
            if (share < 1.0f)
                depositTexel(panorama, x, y, (1.0 - static_cast<double>(share)) * dvec3(rgb[0], rgb[1], rgb[2]),
                             cube.size, deposit);
        }
    parallelFor(cube.excess.size(), 1u << 14, [&](std::size_t i) {
        CubeNode& node = cube.excess[i];
        const dvec3 energy = deposit.energy[i];
        const double light = energy.r + energy.g + energy.b;
        node = makeCubeNode(light > 0.0 ? deposit.moment[i] / light : dvec3(cube.base[i].direction), node.solidAngle,
                            vec3(energy));
        for (int c = 0; c < 3; ++c)
            cube.radiance[4 * i + static_cast<std::size_t>(c)] +=
                static_cast<float>(deposit.seen[i][c] / node.solidAngle);
    });
}

} // namespace

RadianceCube makeRadianceCube(const Image& panorama, int size)
{
    RadianceCube cube;
    cube.size = size;
    cube.base.resize(cubeTexelIndex(kCubeFaces, 0, 0, size));
    cube.excess.resize(cube.base.size());
    cube.radiance.resize(4 * cube.base.size());
    setSolidAngles(cube);

    const float threshold = excessThreshold(panorama);
    const int factor =
        std::max(1, panorama.width / (4 * size)); // so that a sub-texel of the cube skips no texel of the source
    const BaseImage base = makeBaseImage(panorama, threshold, factor);
    BaseGather gather(base, cube);
    parallelFor(static_cast<std::size_t>(2 * size), 4, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        y < size ? gather.sideRow(y) : gather.capRow(y - size);
    });
    depositExcess(panorama, threshold, cube);
    return cube;
}

} // namespace torrance
