#include "prepare/zonal_means.h"

#include <algorithm>

namespace torrance {

void PointsInSteps::collect(std::size_t step, const Cap& cap, bool isBlock)
{
    points[step].clear();
    undecided[step].clear();
    places = step == 0 ? rootsOf(tree) : undecided[step - 1];
    const auto take = [&](const CubeNode& node, float cosine) { points[step].add(node, cosine, cap.radius); };
    if (isBlock)
        collectPoints(tree, cap, opening, places, take);
    else
        collectCommonPoints(tree, cap, opening, places, undecided[step], take);
}

Cap capOfBlocks(const TexelSquare& square, int size)
{
    Cap cap = capOfTexels(square.face, square.x, square.y, square.side, size);
    if (square.side == kBlockSide)
        return cap;
    const int half = square.side / 2;
    for (const int y : {0, half})
        for (const int x : {0, half}) {
            const Cap part = capOfBlocks({square.face, square.x + x, square.y + y, half}, size);
            cap.radius = std::max(cap.radius, glm::length(part.centre - cap.centre) + part.radius);
        }
    return cap;
}

} // namespace torrance
