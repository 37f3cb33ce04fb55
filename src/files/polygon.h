// Polygons cut into triangles.
#pragma once

#include "math/vector.h"

#include <cstdint>
#include <span>
#include <vector>

namespace torrance {

/// Twice the area of the polygon, along its normal (Newell's method): any number of corners, flat or not.
dvec3 newellVector(std::span<const dvec3> corners);

/// What may be spent on concave polygons: every test of a corner against a triangle takes one. Cutting one of n corners
/// takes some n^2 of them, and up to n^3 where it is made to.
struct CuttingBudget
{
    std::uint64_t tests = std::uint64_t(1) << 30; // some seconds
};

/// Appends the triangles of a polygon of three corners or more, each as three numbers of `corners`, wound as the
/// polygon is. A convex one becomes a fan, one of four corners is cut along its shorter diagonal, a concave one is cut
/// ear by ear in the plane that fits it best. What crosses itself gives n - 2 triangles all the same. False where the
/// budget is spent.
bool triangulate(std::span<const dvec3> corners, std::vector<std::uint32_t>& triangles, CuttingBudget& budget);

} // namespace torrance
