// Means over the sphere under a kernel about each texel of a cube: the loop that prefiltering and irradiance share.
#pragma once

#include "math/cube.h"
#include "math/lanes.h"
#include "prepare/cube_tree.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace torrance {

inline constexpr int kBlockSide = 4; // texels of a face that share one list of points

/// The smallest cap about the middle of side x side texels that holds all their centres.
Cap capOfTexels(int face, int firstX, int firstY, int side, int size);

/// The directions of kBlockSide x kBlockSide neighbouring texels, one column per coordinate.
struct ReceiverBlock
{
    static constexpr std::size_t kCount = kBlockSide * kBlockSide;
    std::array<float, kCount> x, y, z;
    Cap cap;

    ReceiverBlock(int face, int firstX, int firstY, int size);
};

/// Sums over a list of points of kernel * energy, and of kernel * solid angle.
struct KernelSums
{
    std::array<float, ReceiverBlock::kCount> red{}, green{}, blue{}, weight{};
};

/// Points by what a block's kernel must do for them.
struct PointLists
{
    std::vector<CubeNode> whole;     // every receiver sees all of it
    std::vector<CubeNode> atHorizon; // some may see a part alone

    void clear()
    {
        whole.clear();
        atHorizon.clear();
    }
    /// Of receivers of a cap that meet the node at this cosine. One that none of them sees is left out.
    void add(const CubeNode& node, float cosine, float radius)
    {
        if (cosine - radius >= node.spread)
            whole.push_back(node);
        else if (cosine + radius > -node.spread)
            atHorizon.push_back(node);
    }
};

/// Mean of max(0, cosine + t) over t in [-spread, spread]: a patch that the horizon cuts is lit in part. `cosine` is
/// its centre's.
TORRANCE_INLINE Lanes clampedCosine(const Lanes& cosine, float spread)
{
    const Lanes none = {}, above = cosine - spread, twice = none + 2.0f * spread;
    Lanes risen = cosine + spread;
    risen = risen > none ? risen : none;
    risen = risen < twice ? risen : twice;
    return risen * risen * (0.25f / spread) + (above > none ? above : none);
}

/// A kernel is given eight receivers and a point.
struct Receivers
{
    Lanes x, y, z;

    TORRANCE_INLINE Lanes cosine(const CubeNode& point) const
    {
        return x * point.direction.x + y * point.direction.y + z * point.direction.z;
    }
    /// sin^2(theta / 2) = |n - l|^2 / 4, which does not cancel near the axis.
    TORRANCE_INLINE Lanes halfSine2(const CubeNode& point) const
    {
        const Lanes dx = x - point.direction.x, dy = y - point.direction.y, dz = z - point.direction.z;
        return 0.25f * (dx * dx + dy * dy + dz * dz);
    }
};

inline constexpr std::size_t kChunk =
    64; // points summed before they join the total: rounding grows with the chunk, not the list

namespace detail {

struct LaneSums
{
    Lanes red, green, blue, weight;

    TORRANCE_INLINE void add(const LaneSums& other)
    {
        red += other.red, green += other.green, blue += other.blue, weight += other.weight;
    }
};

template <typename Kernel>
TORRANCE_INLINE void addPointsTo(const ReceiverBlock& block, std::span<const CubeNode> points, const Kernel& kernel,
                                 KernelSums& sums)
{
    for (std::size_t t = 0; t < ReceiverBlock::kCount; t += kLanes) {
        Receivers receivers;
        load(receivers.x, block.x.data() + t);
        load(receivers.y, block.y.data() + t);
        load(receivers.z, block.z.data() + t);
        LaneSums total = {};
        for (std::size_t first = 0; first < points.size(); first += kChunk) {
            LaneSums chunk = {};
            for (const CubeNode& point : points.subspan(first, std::min(kChunk, points.size() - first))) {
                const Lanes k = kernel(receivers, point);
                chunk.red += k * point.energy.r;
                chunk.green += k * point.energy.g;
                chunk.blue += k * point.energy.b;
                chunk.weight += k * point.solidAngle;
            }
            total.add(chunk);
        }
        LaneSums before;
        load(before.red, sums.red.data() + t);
        load(before.green, sums.green.data() + t);
        load(before.blue, sums.blue.data() + t);
        load(before.weight, sums.weight.data() + t);
        total.add(before);
        store(sums.red.data() + t, total.red);
        store(sums.green.data() + t, total.green);
        store(sums.blue.data() + t, total.blue);
        store(sums.weight.data() + t, total.weight);
    }
}

template <typename Kernel>
TORRANCE_AVX2 void addPointsAvx2(const ReceiverBlock& block, std::span<const CubeNode> points, const Kernel& kernel,
                                 KernelSums& sums)
{
    addPointsTo(block, points, kernel, sums);
}

template <typename Kernel>
void addPointsAnywhere(const ReceiverBlock& block, std::span<const CubeNode> points, const Kernel& kernel,
                       KernelSums& sums)
{
    addPointsTo(block, points, kernel, sums);
}

} // namespace detail

template <typename Kernel>
void addPoints(const ReceiverBlock& block, std::span<const CubeNode> points, const Kernel& kernel, KernelSums& sums,
               bool avx2 = processorHasAvx2())
{
    avx2 ? detail::addPointsAvx2(block, points, kernel, sums) : detail::addPointsAnywhere(block, points, kernel, sums);
}

/// Writes the means of one block: the base's energy over the base's own weight, so that a constant stays constant, and
/// the excess's over the kernel's exact integral, so that a sun keeps its energy.
void putMeans(const KernelSums& base, const KernelSums& excess, float kernelIntegral, int face, int firstX, int firstY,
              int size, float* texels);

} // namespace torrance
