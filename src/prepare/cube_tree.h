// Light from all directions as a hierarchy: what is far outside a kernel's core counts as few points, what is near as
// many (Barnes & Hut, A hierarchical O(N log N) force-calculation algorithm, 1986, on the sphere).
#pragma once

#include "math/vector.h"

#include <vector>

namespace torrance {

/// A patch of the sphere as one point: the energy-weighted mean direction of its light, and how far it spreads about
/// it.
struct CubeNode
{
    vec3 direction = vec3(0.0f); // unit
    float spread = 0.0f;         // half the side (radians) of an evenly lit square with the same variance
    float solidAngle = 0.0f;     // sr
    vec3 energy = vec3(0.0f);    // integral of radiance over the patch
};

/// Of a mean vector of unit directions, length <= 1: a square of half side h has the length 1 - h^2 / 3 to second
/// order.
CubeNode makeCubeNode(const dvec3& meanDirection, float solidAngle, const vec3& energy);

/// levels[0] are the texels of a cube of `size`, levels[k] those of a cube of size >> k, down to one per face.
struct CubeTree
{
    int size = 0;
    std::vector<std::vector<CubeNode>> levels;
};

CubeTree buildCubeTree(int size, std::vector<CubeNode> leaves);

/// Points in the layout that loops over many want.
struct PointList
{
    std::vector<float> x, y, z, spread, solidAngle, red, green, blue;

    void clear();
    void add(const CubeNode& node);
    std::size_t size() const { return x.size(); }
};

/// Which nodes are small enough to be points.
struct Opening
{
    float width;          // radians over which the kernel varies at its core; outside it varies over the distance
    float greatestSide;   // radians; larger nodes are opened in any case
    bool leavesAtHorizon; // nodes that the receivers' horizons may cut are opened to the leaves
    bool skipDark;        // nodes without energy are left out
    float end = 2.0f;     // chord from the receivers beyond which the kernel is nothing: such nodes are left out
};

/// The points that light receivers within `radius` (chord) of the unit direction `centre`: nodes no larger than a fixed
/// share of the kernel's scale, to the leaves where need be. Nodes below the horizon of all receivers are left out.
void collectPoints(const CubeTree& tree, const vec3& centre, float radius, const Opening& opening, PointList& points);

} // namespace torrance
