// What a ray between surfaces meets, and how much light gets through.
#pragma once

#include "math/number_stream.h"
#include "reference/material_point.h"

#include <optional>

namespace torrance {

/// A surface that a path goes on from.
struct PathSurface
{
    Hit hit; // of the eye's surfaces nothing is said
    SurfacePoint surface;
    MaterialPoint material;
};

/// Rays meet both sides of every surface. Masks have holes, and blended surfaces cover by their alpha.
class PathRays
{
public:
    /// Keeps a reference.
    explicit PathRays(const RayCaster& caster);
    PathRays(const PathRays&) = delete; // it refers to itself
    PathRays& operator=(const PathRays&) = delete;

    /// The share of light that gets to `from` from `farthest` along `direction`. `from` is relative to the caster's
    /// origin.
    double transmittance(const dvec3& from, const dvec3& direction, double farthest) const;

    /// The next surface along a ray: one that is blended counts as often as it covers.
    std::optional<PathSurface> next(const Ray& ray, NumberStream& numbers) const;

    const RayCaster& caster;

private:
    RayCaster::Accept isThere; // empty where no material has holes or lets light through
};

} // namespace torrance
