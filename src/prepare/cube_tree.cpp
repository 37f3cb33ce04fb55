#include "prepare/cube_tree.h"

#include "math/cube.h"
#include "prepare/cube_levels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace torrance {
namespace {

/// Largest ratio of a node's side to the kernel's scale at its place. The error of taking a node as a point falls with
/// the square; at this ratio prefiltered levels are within 1 % of the full sum
/// (tests/unit/prepare/environment_maps.cpp).
constexpr float kOpening = 0.4f;
/// Below this a node is a point: it only keeps a kernel's division by the spread finite.
constexpr float kLeastSpread = 1e-6f;

/// The mean of the unit directions that a node stands for.
dvec3 meanDirection(const CubeNode& node)
{
    const double h = node.spread;
    return dvec3(node.direction) * (1.0 - h * h / 3.0);
}

CubeNode join(const std::array<const CubeNode*, 4>& parts)
{
    float solidAngle = 0.0f;
    vec3 energy(0.0f);
    dvec3 byEnergy(0.0), byArea(0.0);
    double lightSum = 0.0;
    for (const CubeNode* part : parts) {
        const double light = static_cast<double>(part->energy.r) + part->energy.g + part->energy.b;
        solidAngle += part->solidAngle;
        energy += part->energy;
        byEnergy += meanDirection(*part) * light;
        byArea += meanDirection(*part) * static_cast<double>(part->solidAngle);
        lightSum += light;
    }
    return makeCubeNode(lightSum > 0.0 ? byEnergy / lightSum : byArea / static_cast<double>(solidAngle), solidAngle,
                        energy);
}

std::vector<CubeNode> coarser(const std::vector<CubeNode>& fine, int size)
{
    std::vector<CubeNode> nodes;
    nodes.reserve(fine.size() / 4);
    for (int face = 0; face < kCubeFaces; ++face)
        for (int y = 0; y < size; y += 2)
            for (int x = 0; x < size; x += 2)
                nodes.push_back(join(
                    {&fine[cubeTexelIndex(face, x, y, size)], &fine[cubeTexelIndex(face, x + 1, y, size)],
                     &fine[cubeTexelIndex(face, x, y + 1, size)], &fine[cubeTexelIndex(face, x + 1, y + 1, size)]}));
    return nodes;
}

} // namespace

CubeNode makeCubeNode(const dvec3& mean, float solidAngle, const vec3& energy)
{
    const double length = glm::length(mean);
    return {vec3(mean / length), static_cast<float>(std::sqrt(std::max(0.0, 3.0 * (1.0 - length)))), solidAngle,
            energy};
}

CubeTree buildCubeTree(int size, std::vector<CubeNode> leaves)
{
    assert(leaves.size() == cubeTexelIndex(kCubeFaces, 0, 0, size));
    CubeTree tree{size, {}};
    tree.levels.push_back(std::move(leaves));
    for (int n = size; n > 1; n /= 2)
        tree.levels.push_back(coarser(tree.levels.back(), n));
    return tree;
}

void PointList::clear()
{
    for (std::vector<float>* column : {&x, &y, &z, &spread, &solidAngle, &red, &green, &blue})
        column->clear();
}

void PointList::add(const CubeNode& node)
{
    x.push_back(node.direction.x);
    y.push_back(node.direction.y);
    z.push_back(node.direction.z);
    spread.push_back(std::max(node.spread, kLeastSpread));
    solidAngle.push_back(node.solidAngle);
    red.push_back(node.energy.r);
    green.push_back(node.energy.g);
    blue.push_back(node.energy.b);
}

void collectPoints(const CubeTree& tree, const vec3& centre, float radius, const Opening& opening, PointList& points)
{
    struct Place
    {
        int level, face, x, y;
    };
    std::vector<Place> pending;
    const int top = static_cast<int>(tree.levels.size()) - 1;
    for (int face = kCubeFaces - 1; face >= 0; --face)
        pending.push_back({top, face, 0, 0});
    while (!pending.empty()) {
        const Place at = pending.back();
        pending.pop_back();
        const int n = tree.size >> at.level;
        const CubeNode& node = tree.levels[static_cast<std::size_t>(at.level)][cubeTexelIndex(at.face, at.x, at.y, n)];
        if (opening.skipDark && node.energy == vec3(0.0f))
            continue;
        const float side =
            2.0f / static_cast<float>(n); // the largest angle that a node of this level spans along an axis
        const float reach = radius + std::sqrt(2.0f) * side;
        const float cosine = glm::dot(node.direction, centre);
        if (cosine < -reach)
            continue;
        const float distance = std::max(0.0f, glm::length(node.direction - centre) - radius);
        if (distance > opening.end + std::sqrt(2.0f) * side)
            continue;
        const float scale2 = opening.width * opening.width + distance * distance;
        const bool fine = side <= opening.greatestSide && side * side <= kOpening * kOpening * scale2 &&
                          !(opening.leavesAtHorizon && cosine < reach);
        if (at.level == 0 || fine) {
            points.add(node);
            continue;
        }
        for (const int child : {3, 2, 1, 0})
            pending.push_back({at.level - 1, at.face, 2 * at.x + child % 2, 2 * at.y + child / 2});
    }
}

} // namespace torrance
