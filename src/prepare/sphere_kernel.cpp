#include "prepare/sphere_kernel.h"

#include "prepare/cube_levels.h"

#include <algorithm>

namespace torrance {
Cap capOfTexels(int face, int firstX, int firstY, int side, int size)
{
    const double middleA = cubeTexelCentre(firstX, size) + (side - 1.0) / size;
    const double middleB = cubeTexelCentre(firstY, size) + (side - 1.0) / size;
    Cap cap = {vec3(glm::normalize(cubeVector(face, middleA, middleB))), 0.0f};
    for (const int y : {firstY, firstY + side - 1}) // a corner is the farthest
        for (const int x : {firstX, firstX + side - 1})
            cap.radius = std::max(cap.radius, glm::length(vec3(cubeTexelDirection(face, x, y, size)) - cap.centre));
    return cap;
}

ReceiverBlock::ReceiverBlock(int face, int firstX, int firstY, int size)
    : cap(capOfTexels(face, firstX, firstY, kBlockSide, size))
{
    for (std::size_t t = 0; t < kCount; ++t) {
        const vec3 d(cubeTexelDirection(face, firstX + static_cast<int>(t) % kBlockSide,
                                        firstY + static_cast<int>(t) / kBlockSide, size));
        x[t] = d.x, y[t] = d.y, z[t] = d.z;
    }
}

void putMeans(const KernelSums& base, const KernelSums& excess, float kernelIntegral, int face, int firstX, int firstY,
              int size, float* texels)
{
    for (std::size_t t = 0; t < ReceiverBlock::kCount; ++t) {
        const int x = firstX + static_cast<int>(t) % kBlockSide, y = firstY + static_cast<int>(t) / kBlockSide;
        float* out = texels + 4 * cubeTexelIndex(face, x, y, size);
        out[0] = base.red[t] / base.weight[t] + excess.red[t] / kernelIntegral;
        out[1] = base.green[t] / base.weight[t] + excess.green[t] / kernelIntegral;
        out[2] = base.blue[t] / base.weight[t] + excess.blue[t] / kernelIntegral;
        out[3] = 1.0f;
    }
}

} // namespace torrance
