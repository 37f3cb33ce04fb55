// Where rays meet the shapes whose surface is exact.
#pragma once

#include "math/ray.h"
#include "scene/scene.h"

#include <optional>

namespace torrance {

struct ShapeHit
{
    double distance = 0.0;
    dvec3 normal = dvec3(0.0);   // unit, outwards (sphere) or along the plane's +Z, whichever side is seen
    dvec3 position = dvec3(0.0); // relative to the same origin as the ray's origin
};

/// The ray and `origin` are as in RayCaster: the ray starts at origin + ray.origin. `seen` says which sides count.
enum class Sides
{
    front,
    both,
};

/// The nearest hit with distance > 0, or none. Rays that only touch a sphere miss it.
std::optional<ShapeHit> intersectShape(const AnalyticShape& shape, const dvec3& origin, const Ray& ray, Sides seen);

} // namespace torrance
