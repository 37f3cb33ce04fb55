#include "brdf/multiple_scattering.h"

#include <algorithm>

namespace torrance::brdf {

dvec3 averageSchlick(const dvec3& f0)
{
    return (20.0 * f0 + 1.0) / 21.0;
}

dvec3 M_none(const ShadingPoint& point)
{
    return point.single;
}

// Turquin 2019, eq. 16: 1 + F0 (1 - E) / E, as a blend of what is reflected once and what would be if nothing were
// lost.
dvec3 M_scale(const ShadingPoint& point)
{
    return point.single * ((dvec3(1) - point.f0) + point.f0 / point.E);
}

// Kulla & Conty 2017: what is lost on the way in and on the way out, shared out so that the furnace is whole; Hill 2018
// sums the bounces: the k-th keeps F^k (1 - EAverage)^(k - 2) EAverage of it. The guard holds for a mirror, which loses
// nothing. Tabulated albedos may pass 1 by their rounding: nothing is lost then.
dvec3 M_kulla_conty(const ShadingPoint& point)
{
    const double lost = 1.0 - point.EAverage;
    const double in = std::max(0.0, 1.0 - point.ELight), out = std::max(0.0, 1.0 - point.E);
    const dvec3 F = averageSchlick(point.f0);
    const dvec3 bounces = F * F * point.EAverage / (dvec3(1) - F * lost);
    return point.single + point.spread * bounces * (in * out / std::max(lost, kLeastDenominator));
}

// Fdez-Aguera 2019: the k-th bounce keeps F^k of what is left, and leaves as from a Lambertian surface. The paper does
// this for an environment; a light from one direction is here spread with the same energy.
dvec3 M_fdez_aguera(const ShadingPoint& point)
{
    const double lost = std::max(0.0, 1.0 - point.E);
    const dvec3 once = point.f0 * (point.E - point.bias) + point.bias;
    const dvec3 F = averageSchlick(point.f0);
    return point.single + point.spread * (once * F * lost / (dvec3(1) - F * lost));
}

} // namespace torrance::brdf
