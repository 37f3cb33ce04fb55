#include "prepare/cube_tree.h"

#include "core/parallel.h"
#include "math/cube.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>

namespace torrance {
namespace {

constexpr double kLeastSpread = 1e-6;
constexpr std::size_t kJoinsAtATime = 4096;

/// The mean of the unit directions that a node stands for.
dvec3 meanDirection(const CubeNode& node)
{
    const double h = node.spread;
    return dvec3(node.direction) * (1.0 - h * h / 3.0);
}

CubeNode join(std::span<const CubeNode> parts)
{
    float solidAngle = 0.0f;
    vec3 energy(0.0f);
    dvec3 byEnergy(0.0), byArea(0.0);
    double lightSum = 0.0;
    for (const CubeNode& part : parts) {
        const double light = static_cast<double>(part.energy.r) + part.energy.g + part.energy.b;
        const dvec3 mean = meanDirection(part);
        solidAngle += part.solidAngle;
        energy += part.energy;
        byEnergy += mean * light;
        byArea += mean * static_cast<double>(part.solidAngle);
        lightSum += light;
    }
    return makeCubeNode(lightSum > 0.0 ? byEnergy / lightSum : byArea / static_cast<double>(solidAngle), solidAngle,
                        energy);
}

/// The level above `fine`, whose codes become those of that level.
CubeTree::Level coarser(const std::vector<CubeNode>& fine, std::vector<std::uint32_t>& codes)
{
    CubeTree::Level level;
    std::vector<std::uint32_t> parents;
    for (std::uint32_t i = 0; i < codes.size(); ++i)
        if (parents.empty() || codes[i] / 4 != parents.back()) {
            parents.push_back(codes[i] / 4);
            level.firstChild.push_back(i);
        }
    level.firstChild.push_back(static_cast<std::uint32_t>(codes.size()));
    level.nodes.resize(parents.size());
    parallelFor(parents.size(), kJoinsAtATime, [&](std::size_t i) {
        const std::uint32_t first = level.firstChild[i];
        level.nodes[i] = join(std::span(fine).subspan(first, level.firstChild[i + 1] - first));
    });
    codes = std::move(parents);
    return level;
}

/// The bits of x at the even places.
std::uint32_t spreadBits(std::uint32_t x)
{
    x = (x | x << 8) & 0x00ff00ffu;
    x = (x | x << 4) & 0x0f0f0f0fu;
    x = (x | x << 2) & 0x33333333u;
    return (x | x << 1) & 0x55555555u;
}

} // namespace

CubeNode makeCubeNode(const dvec3& mean, float solidAngle, const vec3& energy)
{
    const double length = glm::length(mean);
    return {vec3(mean / length),
            static_cast<float>(std::max(kLeastSpread, std::sqrt(std::max(0.0, 3.0 * (1.0 - length))))), solidAngle,
            energy};
}

std::uint32_t treeCode(int face, int x, int y, int size)
{
    const auto n = static_cast<std::uint32_t>(size);
    return static_cast<std::uint32_t>(face) * n * n + spreadBits(static_cast<std::uint32_t>(x)) +
           2 * spreadBits(static_cast<std::uint32_t>(y));
}

CubeTree buildCubeTree(int size, CubeLeaves leaves)
{
    assert(leaves.codes.size() == leaves.nodes.size());
    CubeTree tree{size, {}};
    tree.levels.push_back({std::move(leaves.nodes), {}});
    for (int n = size; n > 1; n /= 2)
        tree.levels.push_back(coarser(tree.levels.back().nodes, leaves.codes));
    return tree;
}

std::vector<NodePlace> rootsOf(const CubeTree& tree)
{
    std::vector<NodePlace> roots;
    for (auto face = static_cast<std::uint32_t>(tree.levels.back().nodes.size()); face-- > 0;)
        roots.push_back({static_cast<std::uint32_t>(tree.levels.size()) - 1, face, 1});
    return roots;
}

WalkLimits::WalkLimits(const CubeTree& tree, const Cap& cap, const Opening& opening)
{
    assert(tree.levels.size() <= kMostLevels);
    for (std::size_t level = 0; level < tree.levels.size(); ++level) {
        const float side =
            2.0f / static_cast<float>(tree.size >> level); // the largest angle that a node spans along an axis
        const float extent = std::sqrt(2.0f) * side;
        const auto squared = [](float x) { return x < 0.0f ? -1.0f : x * x; };
        // Small enough at a distance: side <= kOpening sqrt(width^2 + distance^2).
        const float scale2 = side * side / (kOpening * kOpening), width2 = opening.width * opening.width;
        const float distance = scale2 > width2 ? std::sqrt(scale2 - width2) : -HUGE_VALF;
        const bool never = side > opening.greatestSide;
        levels[level] = {.reach = cap.radius + extent,
                         .end2 = squared(opening.end + extent + cap.radius),
                         .smallForAll2 = never ? HUGE_VALF : squared(distance + cap.radius),
                         .smallForAny2 = never ? HUGE_VALF : squared(distance - cap.radius)};
    }
}

} // namespace torrance
