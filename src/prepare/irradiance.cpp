#include "prepare/irradiance.h"

#include "core/parallel.h"
#include "math/latlong.h"
#include "math/spherical_harmonics.h"
#include "prepare/cube_levels.h"
#include "prepare/sphere_kernel.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

/// The cosine is smooth: points this coarse (per face side) suffice, finer ones for suns, whose place beside the
/// horizon counts.
constexpr int kBaseSize = 32;
constexpr int kExcessSize = 128;

struct AtHorizon
{
    TORRANCE_INLINE Lanes operator()(const Receivers& receivers, const CubeNode& point) const
    {
        return clampedCosine(receivers.cosine(point), point.spread);
    }
};

/// The sum over points of direction times energy and times solid angle: the cosine is linear, so that this is all that
/// matters of points that every receiver sees whole.
struct Moment
{
    dvec3 red{0.0}, green{0.0}, blue{0.0}, weight{0.0};

    Moment() = default;
    explicit Moment(const CubeNode& point)
        : red(dvec3(point.direction) * static_cast<double>(point.energy.r)),
          green(dvec3(point.direction) * static_cast<double>(point.energy.g)),
          blue(dvec3(point.direction) * static_cast<double>(point.energy.b)),
          weight(dvec3(point.direction) * static_cast<double>(point.solidAngle))
    {
    }

    void add(const Moment& other)
    {
        red += other.red, green += other.green, blue += other.blue, weight += other.weight;
    }

    void addTo(KernelSums& sums, const ReceiverBlock& block) const
    {
        for (std::size_t t = 0; t < ReceiverBlock::kCount; ++t) {
            const dvec3 n(block.x[t], block.y[t], block.z[t]);
            sums.red[t] += static_cast<float>(glm::dot(n, red));
            sums.green[t] += static_cast<float>(glm::dot(n, green));
            sums.blue[t] += static_cast<float>(glm::dot(n, blue));
            sums.weight[t] += static_cast<float>(glm::dot(n, weight));
        }
    }
};

/// The nodes of one level of a tree as points, with the moments of all that lie under each node above them.
class CosineTree
{
public:
    CosineTree(const CubeTree& lightTree, int greatestSize) : tree(lightTree)
    {
        while (tree.size >> first > greatestSize)
            ++first;
        moments.resize(tree.levels.size());
        for (const CubeNode& node : tree.levels[first].nodes)
            moments[first].emplace_back(node);
        for (std::size_t level = first + 1; level < tree.levels.size(); ++level)
            for (std::size_t i = 0; i < tree.levels[level].nodes.size(); ++i) {
                moments[level].emplace_back();
                for (auto child = firstChild(level, i); child < firstChild(level, i + 1); ++child)
                    moments[level].back().add(moments[level - 1][child]);
            }
    }

    KernelSums sums(const ReceiverBlock& block) const
    {
        PointLists points;
        Moment whole;
        std::vector<NodePlace> places = rootsOf(tree);
        while (!places.empty()) {
            const NodePlace at = places.back();
            places.pop_back();
            const CubeNode& node = tree.levels[at.level].nodes[at.first];
            const float cosine = glm::dot(node.direction, block.cap.centre);
            const bool opened = at.level > first;
            const float extent = opened ? extentOf(at.level) : node.spread;
            if (cosine + block.cap.radius <= -extent)
                continue;
            if (cosine - block.cap.radius >= extent)
                whole.add(moments[at.level][at.first]);
            else if (!opened)
                points.atHorizon.push_back(node);
            else
                for (auto child = firstChild(at.level, at.first + 1); child-- > firstChild(at.level, at.first);)
                    places.push_back({at.level - 1, child, 1});
        }
        KernelSums sums;
        addPoints(block, points.atHorizon, AtHorizon(), sums);
        whole.addTo(sums, block);
        return sums;
    }

private:
    std::uint32_t firstChild(std::size_t level, std::size_t number) const
    {
        return tree.levels[level].firstChild[number];
    }

    /// Chord from a node's direction within which its points lie with their spread: the diagonal of a square of the
    /// largest angle that a node spans, and another side.
    float extentOf(std::size_t level) const
    {
        return (std::sqrt(2.0f) + 1.0f) * 2.0f / static_cast<float>(tree.size >> level);
    }

    const CubeTree& tree;
    std::size_t first = 0; // level
    std::vector<std::vector<Moment>> moments;
};

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
    const CosineTree ofBase(base, kBaseSize), ofExcess(excess, kExcessSize);
    const int blocks = size / kBlockSide;
    parallelFor(static_cast<std::size_t>(kCubeFaces * blocks * blocks), 4, [&](std::size_t i) {
        const int n = static_cast<int>(i);
        const int face = n / (blocks * blocks), y = n / blocks % blocks * kBlockSide, x = n % blocks * kBlockSide;
        const ReceiverBlock block(face, x, y, size);
        putMeans(ofBase.sums(block), ofExcess.sums(block), static_cast<float>(kPi), face, x, y, size, texels.data());
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
