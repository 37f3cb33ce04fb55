// Directions drawn from the densities of shading. Frame: +Z is the normal; u is a point of the unit square.
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <cmath>

namespace torrance {

/// Density NoL / pi over the hemisphere (Malley's method: the disk lifted to the sphere).
inline dvec3 sampleCosine(const dvec2& u)
{
    const double radius = std::sqrt(u.x);
    const double phi = 2.0 * kPi * u.y;
    return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(std::max(0.0, 1.0 - u.x))};
}

/// A microfacet normal h of the GGX distribution with tangent roughnesses alpha (x, y), density D(h) (n . h).
inline dvec3 sampleGgxNormal(const dvec2& alpha, const dvec2& u)
{
    const double slope =
        std::sqrt(u.x / (1.0 - u.x)); // Walter et al. 2007, eq. 35, of the surface stretched to alpha = 1
    const double phi = 2.0 * kPi * u.y;
    return glm::normalize(dvec3(alpha.x * slope * std::cos(phi), alpha.y * slope * std::sin(phi), 1.0));
}

/// A normal h that is visible from v (v.z > 0), density G1(v) max(0, v . h) D(h) / v.z: Dupuy & Benyoub 2023,
/// listing 3. In the space where the surface is a hemisphere, the reflected directions fill a spherical cap evenly.
inline dvec3 sampleGgxVisibleNormal(const dvec3& v, const dvec2& alpha, const dvec2& u)
{
    const dvec3 stretched = glm::normalize(dvec3(alpha.x * v.x, alpha.y * v.y, v.z));
    const double z = (1.0 - u.x) * (1.0 + stretched.z) - stretched.z;
    const double radius = std::sqrt(std::clamp(1.0 - z * z, 0.0, 1.0));
    const double phi = 2.0 * kPi * u.y;
    const dvec3 h = dvec3(radius * std::cos(phi), radius * std::sin(phi), z) + stretched;
    return glm::normalize(dvec3(alpha.x * h.x, alpha.y * h.y, h.z));
}

} // namespace torrance
