// How a panorama lies around the scene: three.js, Filament, F3D and Blender (in glTF axes) agree on this one.
// Column u = 0.5 + atan2(z, x) / 2 pi, row v = acos(y) / pi: the top row is +Y, the middle of the picture is +X.
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <cmath>

namespace torrance {

/// (u, v) in [0, 1] of a unit direction. On the axis, where the column has no meaning, u = 0.5.
inline dvec2 latLongFromDirection(const dvec3& d)
{
    const double sinTheta = std::sqrt(d.x * d.x + d.z * d.z);
    // atan2 instead of acos(y): near the poles acos loses half of the digits
    return {0.5 + std::atan2(d.z, d.x) / (2.0 * kPi), std::atan2(sinTheta, d.y) / kPi};
}

/// The unit direction of (u, v); u is periodic.
inline dvec3 directionFromLatLong(const dvec2& uv)
{
    const double phi = 2.0 * kPi * (uv.x - 0.5);
    const double theta = kPi * uv.y;
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

/// Solid angle (sr) of one texel in row `row` of a width x height panorama; all texels add up to 4 pi.
inline double latLongTexelSolidAngle(int row, int width, int height)
{
    const double middle = kPi * (row + 0.5) / height;
    // cos(top) - cos(bottom) as a product: no cancellation
    return 2.0 * kPi / width * 2.0 * std::sin(middle) * std::sin(0.5 * kPi / height);
}

} // namespace torrance
