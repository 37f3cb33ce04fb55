#include "prepare/irradiance.h"

#include "core/parallel.h"
#include "math/latlong.h"
#include "math/spherical_harmonics.h"
#include "prepare/cube_levels.h"
#include "prepare/sphere_kernel.h"

#include <algorithm>

namespace torrance {
namespace {

/// The cosine is smooth: points this coarse (per face side) suffice, finer ones for suns, whose place beside the
/// horizon counts.
constexpr int kBaseSize = 32;
constexpr int kExcessSize = 128;

PointList pointsOf(const CubeTree& tree, int greatestSize, bool skipDark)
{
    std::size_t level = 0;
    while (tree.size >> level > greatestSize)
        ++level;
    PointList points;
    for (const CubeNode& node : tree.levels[level])
        if (!skipDark || node.energy != vec3(0.0f))
            points.add(node);
    return points;
}

/// Columns, at least, at which the harmonics are taken, so that those of an even environment vanish to 1e-5 in however
/// few texels it is given.
constexpr int kLeastColumns = 1024;

Sh9 integralOverTexel(int x, int y, int width, int height)
{
    const int parts = (kLeastColumns + width - 1) / width;
    Sh9 integral{};
    for (int v = y * parts; v < (y + 1) * parts; ++v) {
        const double omega = latLongTexelSolidAngle(v, width * parts, height * parts);
        for (int u = x * parts; u < (x + 1) * parts; ++u) {
            const Sh9 basis =
                shBasis(directionFromLatLong({(u + 0.5) / (width * parts), (v + 0.5) / (height * parts)}));
            for (std::size_t i = 0; i < 9; ++i)
                integral[i] += omega * basis[i];
        }
    }
    return integral;
}

} // namespace

std::vector<float> irradianceFaces(const CubeTree& base, const CubeTree& excess, int size)
{
    std::vector<float> texels(4 * cubeTexelIndex(kCubeFaces, 0, 0, size));
    const PointList basePoints = pointsOf(base, kBaseSize, false);
    const PointList excessPoints = pointsOf(excess, kExcessSize, true);
    const auto cosine = [](float q, float spread) { return clampedCosine(1.0f - 2.0f * q, spread); };
    const int blocks = size / kBlockSide;
    parallelFor(static_cast<std::size_t>(kCubeFaces * blocks * blocks), 4, [&](std::size_t i) {
        const int n = static_cast<int>(i);
        const int face = n / (blocks * blocks), y = n / blocks % blocks * kBlockSide, x = n % blocks * kBlockSide;
        const ReceiverBlock block(face, x, y, size);
        KernelSums ofBase, ofExcess;
        addPoints(block, basePoints, cosine, ofBase);
        addPoints(block, excessPoints, cosine, ofExcess);
        putMeans(ofBase, ofExcess, static_cast<float>(kPi), face, x, y, size, texels.data());
    });
    return texels;
}

std::array<vec3, 9> irradianceHarmonics(const Image& panorama)
{
    using Coefficients = std::array<dvec3, 9>;
    std::vector<Coefficients> rows(static_cast<std::size_t>(panorama.height));
    parallelFor(rows.size(), 8, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        Coefficients sum{};
        for (int x = 0; x < panorama.width; ++x) {
            const Sh9 basis = integralOverTexel(x, y, panorama.width, panorama.height);
            const float* rgb = panorama.at(x, y);
            for (std::size_t i = 0; i < 9; ++i)
                sum[i] += basis[i] * dvec3(rgb[0], rgb[1], rgb[2]);
        }
        rows[row] = sum;
    });
    constexpr std::array<int, 9> kBand = {0, 1, 1, 1, 2, 2, 2, 2, 2};
    std::array<vec3, 9> sh;
    for (std::size_t i = 0; i < 9; ++i) {
        dvec3 total(0.0);
        for (const Coefficients& row : rows)
            total += row[i];
        sh[i] = vec3(total * (clampedCosineBand(kBand[i]) / kPi));
    }
    return sh;
}

} // namespace torrance
