#include "brdf/fresnel.h"
#include "math/powers.h"

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

// Where c (1 - c)^6, the shape of what Schlick's term misses, is greatest (Hoffman 2019), and its value there.
constexpr double kDipCosine = 1.0 / 7.0;
constexpr double kDip = 46656.0 / 823543.0; // 6^6 / 7^7

double dip(double c, double oneLessC)
{
    return c * std::pow(oneLessC, 6) / kDip;
}

// Lazanyi & Szirmay-Kalos 2005: Schlick's term with the normal reflectance of eta + i k.
double indexedSchlick(double grazing, double eta, double k)
{
    const double apart = (eta - 1.0) * (eta - 1.0) + k * k;
    return (apart + 4.0 * eta * grazing) / (apart + 4.0 * eta);
}

double lazanyi(double c, double oneLessC, double eta, double k)
{
    if (eta == 1 && k == 0)
        return 0; // no interface, at grazing too
    const double missed = indexedSchlick(fifthPower(1.0 - kDipCosine), eta, k) - conductor(kDipCosine, eta, k);
    const double F = indexedSchlick(fifthPower(oneLessC), eta, k) - missed * dip(c, oneLessC);
    return std::clamp(F, 0.0, 1.0);
}

} // namespace

// Schlick 1994, eq. 15.
dvec3 F_schlick(const ShadingPoint& point)
{
    const double grazing = fifthPower(point.oneLessVoH);
    return point.f0 * (1.0 - grazing) + point.f90 * grazing;
}

// Karis 2013, eq. 5: a power of two for the fifth power. 2^-12.54 of the grazing reflectance is left head-on.
dvec3 F_sg(const ShadingPoint& point)
{
    const double grazing = std::exp2((-5.55473 * point.VoH - 6.98316) * point.VoH);
    return point.f0 * (1.0 - grazing) + point.f90 * grazing;
}

// Hoffman 2019, with his reflectance at the cosine 1/7 given as a share of Schlick's: Kutz et al. 2021, F82-tint. A
// dark tint makes the difference negative beside that cosine, and a tint above 1 passes 1: held within [0, 1], which
// alters nothing for tints of [25/49, 1].
dvec3 F_f82(const ShadingPoint& point)
{
    const dvec3 slope = point.f90 - point.f0;
    const dvec3 schlick = point.f0 + slope * fifthPower(point.oneLessVoH);
    const dvec3 missed = (point.f0 + slope * fifthPower(1.0 - kDipCosine)) * (dvec3(1) - point.f82);
    return glm::clamp(schlick - missed * dip(point.VoH, point.oneLessVoH), dvec3(0), dvec3(1));
}

// Lazanyi & Szirmay-Kalos 2005 fit the term's height and its power for each metal; here the power is 6 and the height
// that which meets Fresnel's equations where the term is greatest (Hoffman 2019). Held within [0, 1], which weakly
// absorbing indices near 1 leave.
dvec3 F_lazanyi(const ShadingPoint& point)
{
    const double c = std::clamp(point.VoH, 0.0, 1.0);
    return {lazanyi(c, point.oneLessVoH, point.eta.r, point.k.r), lazanyi(c, point.oneLessVoH, point.eta.g, point.k.g),
            lazanyi(c, point.oneLessVoH, point.eta.b, point.k.b)};
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
