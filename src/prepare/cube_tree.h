// Light from all directions as a hierarchy: what is far outside a kernel's core counts as few points, what is near as
// many (Barnes & Hut, A hierarchical O(N log N) force-calculation algorithm, 1986, on the sphere).
#pragma once

#include "math/vector.h"

#include <cstdint>
#include <vector>

namespace torrance {

/// A patch of the sphere as one point: the energy-weighted mean direction of its light, and how far it spreads about
/// it. Eight floats: loops over many read them one after the other.
struct CubeNode
{
    vec3 direction = vec3(0.0f); // unit
    float spread = 0.0f;         // half the side (radians) of an evenly lit square with the same variance
    float solidAngle = 0.0f;     // sr
    vec3 energy = vec3(0.0f);    // integral of radiance over the patch
};

/// Of a mean vector of unit directions, length <= 1: a square of half side h has the length 1 - h^2 / 3 to second
/// order. The spread is never quite 0, so that kernels may divide by it.
CubeNode makeCubeNode(const dvec3& meanDirection, float solidAngle, const vec3& energy);

/// Where a texel of a cube of `size` (a power of two) lies in the order of a tree: four neighbours after each other,
/// and their parent has a quarter of their code.
std::uint32_t treeCode(int face, int x, int y, int size);

/// Patches by rising code, each once; those that are not there have no light.
struct CubeLeaves
{
    std::vector<std::uint32_t> codes;
    std::vector<CubeNode> nodes;
};

struct CubeTree
{
    struct Level
    {
        std::vector<CubeNode> nodes;
        std::vector<std::uint32_t> firstChild; // in the level before, and one more; empty for the leaves
    };
    int size = 0;
    std::vector<Level> levels; // texels of a cube of size >> level, down to one per face
};

CubeTree buildCubeTree(int size, CubeLeaves leaves);

/// Receivers: all directions within `radius` (chord) of a unit one.
struct Cap
{
    vec3 centre;
    float radius;
};

/// Which nodes are small enough to be points.
struct Opening
{
    float width;          // radians over which the kernel varies at its core; outside it varies over the distance
    float greatestSide;   // radians; larger nodes are opened in any case
    bool leavesAtHorizon; // nodes that the receivers' horizons may cut are opened to the leaves
    float end = 2.0f;     // chord from the receivers beyond which the kernel is nothing: such nodes are left out
};

/// Up to four neighbouring nodes of one level.
struct NodePlace
{
    std::uint32_t level, first, count;
};

/// The roots of a tree: one per face that has light.
std::vector<NodePlace> rootsOf(const CubeTree& tree);

/// The points that light all receivers of a cap: nodes no larger than a fixed share of the kernel's scale, to the
/// leaves where need be. Nodes below the horizon of all receivers are left out. Gives what lies at `places` (which are
/// used up) and below to take(node, cosine), the cosine that of node and cap, in an order that depends on nothing else.
template <typename Take>
void collectPoints(const CubeTree& tree, const Cap& cap, const Opening& opening, std::vector<NodePlace>& places,
                   const Take& take);

/// The same for many caps within a wide one: takes the points of them all. From `undecided` down each goes on by
/// itself, to the very points that it would have found alone.
template <typename Take>
void collectCommonPoints(const CubeTree& tree, const Cap& wide, const Opening& opening, std::vector<NodePlace>& places,
                         std::vector<NodePlace>& undecided, const Take& take);

} // namespace torrance

#include "prepare/cube_tree_walk.h"
