#include "prepare/radiance_pyramid.h"

#include "math/cube.h"

#include <bit>

namespace torrance {
namespace {

std::vector<float> halved(const std::vector<float>& fine, int fineSize)
{
    const int size = fineSize / 2;
    std::vector<float> coarse(4 * cubeTexelIndex(kCubeFaces, 0, 0, size), 1.0f);
    for (int face = 0; face < kCubeFaces; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                dvec4 energy(0.0);
                double solidAngle = 0.0;
                for (const auto& [fx, fy] :
                     {std::pair(2 * x, 2 * y), {2 * x + 1, 2 * y}, {2 * x, 2 * y + 1}, {2 * x + 1, 2 * y + 1}}) {
                    const float* texel = fine.data() + 4 * cubeTexelIndex(face, fx, fy, fineSize);
                    const double omega = cubeTexelSolidAngle(fx, fy, fineSize);
                    energy += omega * dvec4(texel[0], texel[1], texel[2], texel[3]);
                    solidAngle += omega;
                }
                float* texel = coarse.data() + 4 * cubeTexelIndex(face, x, y, size);
                for (int c = 0; c < 4; ++c)
                    texel[c] = static_cast<float>(energy[c] / solidAngle);
            }
    return coarse;
}

} // namespace

CubeLevels radiancePyramid(const std::vector<float>& radiance, int size)
{
    CubeLevels cube = {.size = size, .levels = std::countr_zero(static_cast<unsigned>(size)) + 1, .data = {radiance}};
    for (int level = 1; level < cube.levels; ++level)
        cube.data.push_back(halved(cube.data.back(), cube.sizeOf(level - 1)));
    return cube;
}

} // namespace torrance
