// Directions drawn from the densities of shading, and these densities. Frame: +Z is the normal; u is a point of the
// unit square.
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

/// Of sampleCosine, 1/sr.
inline double cosineDensity(const dvec3& l)
{
    return std::max(0.0, l.z) / kPi;
}

/// A microfacet normal h of the GGX distribution with tangent roughnesses alpha (x, y), density D(h) (n . h).
inline dvec3 sampleGgxNormal(const dvec2& alpha, const dvec2& u)
{
    const double slope =
        std::sqrt(u.x / (1.0 - u.x)); // Walter et al. 2007, eq. 35, of the surface stretched to alpha = 1
    const double phi = 2.0 * kPi * u.y;
    return glm::normalize(dvec3(alpha.x * slope * std::cos(phi), alpha.y * slope * std::sin(phi), 1.0));
}

/// D(h), 1/sr, of a unit h above the surface: Heitz 2014, eq. 85.
inline double ggxNormalDensity(const dvec2& alpha, const dvec3& h)
{
    const double x = h.x / alpha.x, y = h.y / alpha.y;
    const double stretched2 = x * x + y * y + h.z * h.z;
    return 1.0 / (kPi * alpha.x * alpha.y * stretched2 * stretched2);
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

/// The same density by another road: Heitz, Sampling the GGX Distribution of Visible Normals, 2018, listing 1. In the
/// stretched space the hemisphere seen from v projects to a disk of which one half is squeezed.
inline dvec3 sampleGgxVisibleNormalHeitz(const dvec3& v, const dvec2& alpha, const dvec2& u)
{
    const dvec3 stretched = glm::normalize(dvec3(alpha.x * v.x, alpha.y * v.y, v.z));
    const double across = std::sqrt(stretched.x * stretched.x + stretched.y * stretched.y);
    const dvec3 t1 = across > 0.0 ? dvec3(-stretched.y, stretched.x, 0.0) / across : dvec3(1.0, 0.0, 0.0);
    const dvec3 t2 = glm::cross(stretched, t1);
    const double radius = std::sqrt(u.x);
    const double phi = 2.0 * kPi * u.y;
    const double x = radius * std::cos(phi);
    const double squeeze = 0.5 * (1.0 + stretched.z);
    const double y = (1.0 - squeeze) * std::sqrt(1.0 - x * x) + squeeze * radius * std::sin(phi);
    const dvec3 h = x * t1 + y * t2 + std::sqrt(std::max(0.0, 1.0 - x * x - y * y)) * stretched;
    return glm::normalize(dvec3(alpha.x * h.x, alpha.y * h.y, std::max(0.0, h.z)));
}

/// Of sampleGgxVisibleNormal, 1/sr. G1(v) / v.z = 2 / (v.z + |stretched v|) has no 0/0 at grazing.
inline double ggxVisibleNormalDensity(const dvec3& v, const dvec2& alpha, const dvec3& h)
{
    const double length = glm::length(dvec3(alpha.x * v.x, alpha.y * v.y, v.z));
    return 2.0 * std::max(0.0, glm::dot(v, h)) * ggxNormalDensity(alpha, h) / (v.z + length);
}

/// How far the cap of reflected directions reaches below the horizon of the stretched space: Eto & Tokuyoshi, Bounded
/// VNDF Sampling for Smith-GGX Reflections, 2023, eq. 5. At most 1, which is the whole cap of Dupuy & Benyoub.
inline double ggxCapShare(const dvec3& v, const dvec2& alpha)
{
    const double a = std::min({alpha.x, alpha.y, 1.0});
    const double s = 1.0 + std::sqrt(v.x * v.x + v.y * v.y);
    return (1.0 - a * a) * s * s / (s * s + a * a * v.z * v.z);
}

/// A reflected direction l of the GGX surface seen from v (v.z > 0), with fewer below the horizon than reflection at
/// sampleGgxVisibleNormal gives: Eto & Tokuyoshi 2023, listing 1.
inline dvec3 sampleGgxReflection(const dvec3& v, const dvec2& alpha, const dvec2& u)
{
    const dvec3 stretched = glm::normalize(dvec3(alpha.x * v.x, alpha.y * v.y, v.z));
    const double lowest = ggxCapShare(v, alpha) * stretched.z;
    const double z = (1.0 - u.x) * (1.0 + lowest) - lowest;
    const double radius = std::sqrt(std::clamp(1.0 - z * z, 0.0, 1.0));
    const double phi = 2.0 * kPi * u.y;
    const dvec3 sum = dvec3(radius * std::cos(phi), radius * std::sin(phi), z) + stretched;
    const dvec3 h = glm::normalize(dvec3(alpha.x * sum.x, alpha.y * sum.y, sum.z));
    return 2.0 * glm::dot(v, h) * h - v;
}

/// Of sampleGgxReflection, 1/sr: Eto & Tokuyoshi 2023, eq. 8. It holds for directions above the horizon; of those
/// below, which reflect nothing, some are drawn and some are not.
inline double ggxReflectionDensity(const dvec3& v, const dvec2& alpha, const dvec3& l)
{
    const dvec3 sum = v + l;
    const double length2 = glm::dot(sum, sum);
    if (!(length2 > 0.0) || sum.z <= 0.0)
        return 0.0;
    const double length = glm::length(dvec3(alpha.x * v.x, alpha.y * v.y, v.z));
    return ggxNormalDensity(alpha, sum / std::sqrt(length2)) / (2.0 * (ggxCapShare(v, alpha) * v.z + length));
}

/// An even direction of the cone about +Z whose half angle has 1 - cos = `oneLessCosine` (in (0, 2]): all directions in
/// which a sphere is seen. Density 1 / (2 pi oneLessCosine).
inline dvec3 sampleCone(double oneLessCosine, const dvec2& u)
{
    const double below = u.x * oneLessCosine; // 1 - cos, kept apart: a far sphere's cone is narrow
    const double sine = std::sqrt(std::max(0.0, below * (2.0 - below)));
    const double phi = 2.0 * kPi * u.y;
    return {sine * std::cos(phi), sine * std::sin(phi), 1.0 - below};
}

} // namespace torrance
