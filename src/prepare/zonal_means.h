// One level of a prefiltered cube: means over the sphere under a kernel about each texel.
#pragma once

#include "core/parallel.h"
#include "prepare/cube_levels.h"
#include "prepare/sphere_kernel.h"

#include <vector>

namespace torrance {

/// Which nodes of both parts of a radiance cube become points.
struct Openings
{
    Opening base, excess;
};

/// 6 faces of `size` (a multiple of kBlockSide), RGBA. `kernel` as addPoints has it, `integral` is its own over the
/// sphere.
template <typename Kernel>
std::vector<float> zonalMeans(const CubeTree& base, const CubeTree& excess, int size, const Openings& openings,
                              double integral, const Kernel& kernel)
{
    std::vector<float> texels(4 * cubeTexelIndex(kCubeFaces, 0, 0, size));
    const int blocks = size / kBlockSide;
    parallelFor(static_cast<std::size_t>(kCubeFaces * blocks), 1, [&](std::size_t row) {
        const int face = static_cast<int>(row) / blocks, y = static_cast<int>(row) % blocks * kBlockSide;
        PointList points;
        for (int x = 0; x < size; x += kBlockSide) {
            const ReceiverBlock block(face, x, y, size);
            KernelSums ofBase, ofExcess;
            points.clear();
            collectPoints(base, block.centre, block.radius, openings.base, points);
            addPoints(block, points, kernel, ofBase);
            points.clear();
            collectPoints(excess, block.centre, block.radius, openings.excess, points);
            addPoints(block, points, kernel, ofExcess);
            putMeans(ofBase, ofExcess, static_cast<float>(integral), face, x, y, size, texels.data());
        }
    });
    return texels;
}

} // namespace torrance
