// The loops of cube_tree.h, which are compiled with what they feed.
#pragma once

#include "prepare/cube_tree.h"

#include <array>
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

template <bool stopsAtUndecided, typename Take>
void walk(const CubeTree& tree, const Cap& cap, const Opening& opening, std::vector<NodePlace>& places,
          std::vector<NodePlace>* undecided, const Take& take)
{
    const WalkLimits limits(tree, cap, opening);
    while (!places.empty()) {
        const NodePlace at = places.back();
        places.pop_back();
        const CubeTree::Level& level = tree.levels[at.level];
        const CubeNode& node = level.nodes[at.number];
        const WalkLimits::Level& limit = limits.levels[at.level];
        const vec3 apart = node.direction - cap.centre;
        const float chord2 = glm::dot(apart, apart), cosine = glm::dot(node.direction, cap.centre);
        if (cosine < -limit.reach || chord2 > limit.end2)
            continue;
        const bool mayBeCut = opening.leavesAtHorizon && cosine < limit.reach;
        if (at.level == 0 || (chord2 >= limit.smallForAll2 && !mayBeCut)) {
            take(node, cosine);
            continue;
        }
        if (stopsAtUndecided && chord2 >= limit.smallForAny2) {
            undecided->push_back(at);
            continue;
        }
        for (std::uint32_t child = level.firstChild[at.number + 1]; child-- > level.firstChild[at.number];)
            places.push_back({at.level - 1, child});
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
void collectCommonPoints(const CubeTree& tree, const Cap& wide, const Opening& opening,
                         std::vector<NodePlace>& places, std::vector<NodePlace>& undecided, const Take& take)
{
    detail::walk<true>(tree, wide, opening, places, &undecided, take);
}

} // namespace torrance
