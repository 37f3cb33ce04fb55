#include "brdf/multiple_scattering.h"

namespace torrance::brdf {

dvec3 M_none(const ShadingPoint&)
{
    return dvec3(1);
}

// Turquin 2019, eq. 16: 1 + F0 (1 - E) / E, as a blend of what is reflected once and what would be if nothing were
// lost.
dvec3 M_scale(const ShadingPoint& point)
{
    return (dvec3(1) - point.f0) + point.f0 / point.E;
}

} // namespace torrance::brdf
