// Emissive meshes as lights: points of them drawn by area and power.
#pragma once

#include "reference/directed_light.h"
#include "reference/surface_point.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace torrance {

/// A point of an emitter as seen from somewhere.
struct EmitterSample
{
    DirectedLight light;          // the radiance times the point's coverage
    dvec3 direction = dvec3(0.0); // unit, towards it
    dvec3 target = dvec3(0.0);    // where a shadow ray ends: off the emitter's surface, relative to the caster's origin
};

/// Triangles are drawn by area times the mean of what their brightest channel emits, and points evenly within them.
/// Analytic shapes are no part of it, nor are triangles that emit nothing at the places that were looked at: paths
/// find these by their own directions.
class Emitters
{
public:
    /// Keeps a reference.
    explicit Emitters(const RayCaster& caster);

    /// Nothing can be drawn.
    bool dark() const { return sums.empty(); }

    /// `from` is relative to the caster's origin; `choice` and `u` are random, in [0, 1). None where the point shows a
    /// side that emits nothing. Not for dark ones.
    std::optional<EmitterSample> draw(const dvec3& from, double choice, const dvec2& u) const;

    /// Of drawing what a ray met, as a direction from where it came, 1/sr; 0 for what is never drawn.
    double density(const Hit& hit, const SurfacePoint& surface) const;

private:
    struct Triangle
    {
        int instance, index;
    };
    double inSolidAngle(const Hit& hit, const SurfacePoint& surface) const;

    const RayCaster& caster;
    std::vector<Triangle> triangles;
    std::vector<double> sums;                     // running, of the triangles' weights
    std::vector<std::uint32_t> guide;             // math/guided_choice.h
    std::vector<std::vector<double>> radiosities; // per instance and triangle, weight per area; empty where none emits
};

} // namespace torrance
