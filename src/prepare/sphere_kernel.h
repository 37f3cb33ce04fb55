// Means over the sphere under a kernel about each texel of a cube: the loop that prefiltering and irradiance share.
#pragma once

#include "math/cube.h"
#include "prepare/cube_tree.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace torrance {

inline constexpr int kBlockSide = 4; // texels of a face that share one list of points

/// The directions of kBlockSide x kBlockSide neighbouring texels, one column per coordinate: loops over them become
/// vector code.
struct ReceiverBlock
{
    static constexpr std::size_t kCount = kBlockSide * kBlockSide;
    std::array<float, kCount> x, y, z;
    vec3 centre;
    float radius; // largest chord from the centre to a texel of the block

    ReceiverBlock(int face, int firstX, int firstY, int size);
};

/// Sums over a list of points of kernel * energy, and of kernel * solid angle.
struct KernelSums
{
    std::array<float, ReceiverBlock::kCount> red{}, green{}, blue{}, weight{};
};

/// Mean of max(0, cosine + t) over t in [-spread, spread]: a patch that the horizon cuts is lit in part. `cosine` is
/// its centre's.
inline float clampedCosine(float cosine, float spread)
{
    const float risen = std::min(std::max(cosine + spread, 0.0f), 2.0f * spread);
    return risen * risen / (4.0f * spread) + std::max(cosine - spread, 0.0f);
}

inline constexpr std::size_t kChunk =
    64; // points summed before they join the total: rounding grows with the chunk, not the list

/// `kernel` is given sin^2(theta / 2) = |n - l|^2 / 4, which does not cancel near the axis, and the point's spread.
template <typename Kernel>
void addPoints(const ReceiverBlock& block, const PointList& points, const Kernel& kernel, KernelSums& sums)
{
    for (std::size_t first = 0; first < points.size(); first += kChunk) {
        KernelSums chunk; // no pointer reaches it: it stays in registers
        for (std::size_t p = first; p < std::min(first + kChunk, points.size()); ++p) {
            const float px = points.x[p], py = points.y[p], pz = points.z[p], spread = points.spread[p];
            const float omega = points.solidAngle[p], red = points.red[p], green = points.green[p],
                        blue = points.blue[p];
            for (std::size_t t = 0; t < ReceiverBlock::kCount; ++t) {
                const float dx = block.x[t] - px, dy = block.y[t] - py, dz = block.z[t] - pz;
                const float k = kernel(0.25f * (dx * dx + dy * dy + dz * dz), spread);
                chunk.red[t] += k * red;
                chunk.green[t] += k * green;
                chunk.blue[t] += k * blue;
                chunk.weight[t] += k * omega;
            }
        }
        for (std::size_t t = 0; t < ReceiverBlock::kCount; ++t) {
            sums.red[t] += chunk.red[t];
            sums.green[t] += chunk.green[t];
            sums.blue[t] += chunk.blue[t];
            sums.weight[t] += chunk.weight[t];
        }
    }
}

/// Writes the means of one block: the base's energy over the base's own weight, so that a constant stays constant, and
/// the excess's over the kernel's exact integral, so that a sun keeps its energy.
void putMeans(const KernelSums& base, const KernelSums& excess, float kernelIntegral, int face, int firstX, int firstY,
              int size, float* texels);

} // namespace torrance
