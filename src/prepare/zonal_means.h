// One level of a prefiltered cube: means over the sphere under a kernel about each texel.
#pragma once

#include "core/parallel.h"
#include "prepare/cube_levels.h"
#include "prepare/sphere_kernel.h"

#include <array>
#include <vector>

namespace torrance {

/// Which nodes of both parts of a radiance cube become points.
struct Openings
{
    Opening base, excess;
};

/// A kernel in the forms that the lists of PointLists need.
template <typename Whole, typename AtHorizon>
struct ZonalKernel
{
    Whole whole;
    AtHorizon atHorizon;
    double integral; // over the sphere

    void add(const ReceiverBlock& block, const PointLists& points, KernelSums& sums) const
    {
        addPoints(block, points.whole, whole, sums);
        addPoints(block, points.atHorizon, atHorizon, sums);
    }
};

/// Square of texels of a face.
struct TexelSquare
{
    int face, x, y, side;
};

/// Texels along a side of the squares that look for their points together: halves of it, and halves of those, then go
/// on by themselves.
inline constexpr int kGreatestSquare = 32;

/// The points of one tree for the squares that hold a block, from the largest down to the block itself.
class PointsInSteps
{
public:
    PointsInSteps(const CubeTree& lightTree, const Opening& howFine) : tree(lightTree), opening(howFine) {}

    /// To be called of squares from the largest to the block, each time after those that hold it.
    void collect(std::size_t step, const Cap& cap, bool isBlock);

    /// Of this and the steps before.
    template <typename Kernel>
    KernelSums sums(std::size_t step, const ReceiverBlock& block, const Kernel& kernel) const
    {
        KernelSums sums;
        for (std::size_t i = 0; i <= step; ++i)
            kernel.add(block, points[i], sums);
        return sums;
    }

private:
    static constexpr std::size_t kSteps = 4; // 32, 16, 8 and 4 texels
    const CubeTree& tree;
    const Opening& opening;
    std::array<PointLists, kSteps> points;
    std::array<std::vector<NodePlace>, kSteps> undecided;
    std::vector<NodePlace> places;
};

/// A cap that holds those of all blocks of the square, so that it may stand for each of them.
Cap capOfBlocks(const TexelSquare& square, int size);

/// 6 faces of `size` (a power of two times kBlockSide), RGBA.
template <typename Kernel>
std::vector<float> zonalMeans(const CubeTree& base, const CubeTree& excess, int size, const Openings& openings,
                              const Kernel& kernel)
{
    std::vector<float> texels(4 * cubeTexelIndex(kCubeFaces, 0, 0, size));
    const int side = std::max(kBlockSide, std::min(kGreatestSquare, size / 2)), along = size / side;
    parallelFor(static_cast<std::size_t>(kCubeFaces * along * along), 1, [&](std::size_t i) {
        const int n = static_cast<int>(i);
        PointsInSteps ofBase(base, openings.base), ofExcess(excess, openings.excess);
        const auto go = [&](const TexelSquare& square, std::size_t step, const auto& goOn) -> void {
            const bool isBlock = square.side == kBlockSide;
            const Cap cap = capOfBlocks(square, size);
            ofBase.collect(step, cap, isBlock);
            ofExcess.collect(step, cap, isBlock);
            if (isBlock) {
                const ReceiverBlock block(square.face, square.x, square.y, size);
                putMeans(ofBase.sums(step, block, kernel), ofExcess.sums(step, block, kernel),
                         static_cast<float>(kernel.integral), square.face, square.x, square.y, size, texels.data());
                return;
            }
            const int half = square.side / 2;
            for (const int y : {0, half})
                for (const int x : {0, half})
                    goOn(TexelSquare{square.face, square.x + x, square.y + y, half}, step + 1, goOn);
        };
        go({n / (along * along), n % along * side, n / along % along * side, side}, 0, go);
    });
    return texels;
}

} // namespace torrance
