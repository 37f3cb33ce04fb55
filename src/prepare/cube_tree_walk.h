// The loops of cube_tree.h, which are compiled with what they feed.
#pragma once

#include "prepare/cube_tree.h"

#include <array>
#include <bit>
#include <cmath>

namespace torrance {

/// Largest ratio of a node's side to the kernel's scale at its place. The error of taking a node as a point falls with
/// the square; at this ratio prefiltered levels are within 1 % of the full sum
/// (tests/unit/prepare/environment_maps.cpp).
inline constexpr float kOpening = 0.4f;

/// What decides on a node of each level, for one cap and opening: limits of the cosine and of the squared chord between
/// the node and the cap's centre.
struct WalkLimits
{
    struct Level
    {
        float reach;        // chord from the centre within which the receivers and the node's extent lie
        float end2;         // beyond it the kernel is nothing
        float smallForAll2; // from here on the node is a point for all receivers of the cap
        float smallForAny2; // below it for none of any cap within this one
    };
    static constexpr std::size_t kMostLevels = 16;
    std::array<Level, kMostLevels> levels;

    WalkLimits(const CubeTree& tree, const Cap& cap, const Opening& opening);
};

namespace detail {

/// Bit i of each says it of the i-th of some neighbours.
struct Verdicts
{
    unsigned points = 0, opened = 0, undecided = 0;
};

/// Of up to four nodes of a level. Without branches: what becomes of a node is hard to foretell.
template <bool stopsAtUndecided>
Verdicts judge(const CubeNode* nodes, std::uint32_t count, const WalkLimits::Level& limit, const Cap& cap,
               const Opening& opening, bool leaves, std::array<float, 4>& cosines)
{
    Verdicts verdicts;
    for (std::uint32_t i = 0; i < count; ++i) {
        const vec3 d = nodes[i].direction, apart = d - cap.centre;
        const float chord2 = glm::dot(apart, apart), cosine = glm::dot(d, cap.centre);
        cosines[i] = cosine;
        const unsigned lights = unsigned(cosine >= -limit.reach) & unsigned(chord2 <= limit.end2);
        const unsigned whole = unsigned(!opening.leavesAtHorizon) | unsigned(cosine >= limit.reach);
        const unsigned point = unsigned(leaves) | (unsigned(chord2 >= limit.smallForAll2) & whole);
        const unsigned undecided = unsigned(stopsAtUndecided) & unsigned(chord2 >= limit.smallForAny2) & ~point;
        verdicts.points |= (lights & point) << i;
        verdicts.undecided |= (lights & undecided) << i;
        verdicts.opened |= (lights & ~point & ~undecided & 1u) << i;
    }
    return verdicts;
}

template <bool stopsAtUndecided, typename Take>
void walk(const CubeTree& tree, const Cap& cap, const Opening& opening, std::vector<NodePlace>& places,
          std::vector<NodePlace>* undecided, const Take& take)
{
    const WalkLimits limits(tree, cap, opening);
    std::array<float, 4> cosines;
    while (!places.empty()) {
        const NodePlace at = places.back();
        places.pop_back();
        const CubeTree::Level& level = tree.levels[at.level];
        const CubeNode* nodes = level.nodes.data() + at.first;
        const Verdicts verdicts =
            judge<stopsAtUndecided>(nodes, at.count, limits.levels[at.level], cap, opening, at.level == 0, cosines);
        for (unsigned left = verdicts.points; left != 0; left &= left - 1) {
            const int i = std::countr_zero(left);
            take(nodes[i], cosines[static_cast<std::size_t>(i)]);
        }
        for (unsigned left = verdicts.undecided; left != 0; left &= left - 1)
            undecided->push_back({at.level, at.first + static_cast<std::uint32_t>(std::countr_zero(left)), 1});
        for (unsigned left = verdicts.opened; left != 0; left &= left - 1) {
            const std::uint32_t* child = level.firstChild.data() + at.first + std::countr_zero(left);
            places.push_back({at.level - 1, child[0], child[1] - child[0]});
        }
    }
}

} // namespace detail

template <typename Take>
void collectPoints(const CubeTree& tree, const Cap& cap, const Opening& opening, std::vector<NodePlace>& places,
                   const Take& take)
{
    detail::walk<false>(tree, cap, opening, places, nullptr, take);
}

template <typename Take>
void collectCommonPoints(const CubeTree& tree, const Cap& wide, const Opening& opening, std::vector<NodePlace>& places,
                         std::vector<NodePlace>& undecided, const Take& take)
{
    detail::walk<true>(tree, wide, opening, places, &undecided, take);
}

} // namespace torrance
