#include "brdf/fresnel.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace torrance::brdf {
namespace {

// Unpolarised reflectance from Snell's law and the two amplitudes (Born & Wolf, section 1.5.2), with the cosine c of
// incidence. Their numerators c - n cos_t and n c - cos_t vanish as n goes to 1, so each is written as a difference of
// squares over the sum:
//   c^2 - (n cos_t)^2 = 1 - n^2,   (n c)^2 - cos_t^2 = (n^2 - 1)(c^2 n^2 - sin^2) / n^2.
double dielectric(double c, double n)
{
    if (n == 0)
        return 1; // infinite index
    if (n == 1)
        return 0; // no interface, at grazing too
    const double sin2T = (1.0 - c) * (1.0 + c) / (n * n);
    if (sin2T >= 1)
        return 1; // beyond the critical angle
    const double m = (n - 1.0) * (n + 1.0);
    const double cosT = std::sqrt((m + c * c) / (n * n));
    const double perpendicular = m / ((c + n * cosT) * (c + n * cosT));
    const double sum = n * c + cosT;
    const double parallel = m * (c * c * n * n - (1.0 - c) * (1.0 + c)) / (n * n * sum * sum);
    return 0.5 * (perpendicular * perpendicular + parallel * parallel);
}

// The same two amplitudes with the complex index eta + i k. u = n cos_t is the root of n^2 - sin^2 with a positive
// imaginary part; (c - u)(c + u) = 1 - n^2 replaces the difference that cancels near n = 1.
double conductor(double c, double eta, double k)
{
    using Complex = std::complex<double>;
    if (eta == 1 && k == 0)
        return 0; // no interface, at grazing too
    const Complex n2((eta - k) * (eta + k), 2.0 * eta * k);
    const Complex m((eta - 1.0) * (eta + 1.0) - k * k, 2.0 * eta * k); // n^2 - 1
    const Complex u = std::sqrt(m + c * c);
    const Complex perpendicular = m / ((c + u) * (c + u));
    const Complex sum = n2 * c + u;
    const Complex parallel = m * (c * c * n2 - (1.0 - c) * (1.0 + c)) / (sum * sum);
    return 0.5 * (std::norm(perpendicular) + std::norm(parallel));
}

} // namespace

// Schlick 1994, eq. 15.
dvec3 F_schlick(const ShadingPoint& point)
{
    const double grazing = std::pow(point.oneLessVoH, 5);
    return point.f0 * (1.0 - grazing) + point.f90 * grazing;
}

dvec3 F_exact_dielectric(const ShadingPoint& point)
{
    return dvec3(dielectric(std::clamp(point.VoH, 0.0, 1.0), point.ior));
}

dvec3 F_exact_conductor(const ShadingPoint& point)
{
    const double c = std::clamp(point.VoH, 0.0, 1.0);
    return {conductor(c, point.eta.r, point.k.r), conductor(c, point.eta.g, point.k.g),
            conductor(c, point.eta.b, point.k.b)};
}

} // namespace torrance::brdf
