// What several source systems share, as they write it.
#pragma once

#include "brdf/brdf_terms.h"
#include "brdf/shading_point.h"
#include "math/powers.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {

/// F0 + (1 - F0)(1 - cosine)^5.
inline dvec3 schlick(const dvec3& F0, double cosine)
{
    return F0 + (dvec3(1) - F0) * fifthPower(1.0 - cosine);
}

/// Schlick's G1: x / (x (1 - k) + k).
inline double schlickMasking(double x, double k)
{
    return x / (x * (1.0 - k) + k);
}

/// alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2).
inline double trowbridgeReitz(double NoH, double alpha)
{
    const double a2 = alpha * alpha;
    const double d = NoH * NoH * (a2 - 1.0) + 1.0;
    return a2 / (kPi * d * d);
}

/// min(1, 2 (n.h)(n.v)/(v.h), 2 (n.h)(n.l)/(v.h)).
inline double grooveAttenuation(const ShadingPoint& p)
{
    return std::min({1.0, 2.0 * p.NoH * p.NoV / p.VoH, 2.0 * p.NoH * p.NoL / p.VoH});
}

/// The groove's masking of the view direction alone.
inline double grooveMasking(const ShadingPoint& p)
{
    return std::min(1.0, 2.0 * p.NoH * p.NoV / p.VoH);
}

/// v or l is not above the surface.
inline bool isDark(const ShadingPoint& p)
{
    return p.NoV <= 0 || p.NoL <= 0;
}

inline dvec3 halfVector(const ShadingPoint& p)
{
    return glm::normalize(p.v + p.l);
}

} // namespace torrance::brdf
