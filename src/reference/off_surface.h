// Where rays between surfaces begin and end.
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <cmath>

namespace torrance {

/// A ray begins this share of its place's size off the surface, on the side that it leaves to: places are computed in
/// double, to some 1e-16 of their size, so that the surface itself, and another that lies in the same plane, are behind
/// it a million times over. It steps over what lies nearer, a nanometre at ten metres.
inline constexpr double kOffSurface = 1e-10;

/// `position` is relative to `origin`; both count, because the world's coordinates are what was rounded. `normal` is
/// the geometric one, towards that side.
inline dvec3 offSurface(const dvec3& origin, const dvec3& position, const dvec3& normal)
{
    const auto size = [](const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
    return position + kOffSurface * (size(origin) + size(position)) * normal;
}

} // namespace torrance
