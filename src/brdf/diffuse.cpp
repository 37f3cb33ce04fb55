#include "brdf/diffuse.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

bool belowHorizon(const ShadingPoint& point)
{
    return point.NoV <= 0 || point.NoL <= 0;
}

// Fujii's Oren-Nayar, whose average over directions EON restores (Portsmouth et al. 2025, section 3). Each constant is
// an integral of G: 1/2 - 2/(3 pi) is G(0)/pi, 2/3 - 28/(15 pi) is its cosine-weighted mean over pi.
const double kGrazing = 0.5 - 2.0 / (3.0 * kPi);
const double kMean = 2.0 / 3.0 - 28.0 / (15.0 * kPi);

// G(theta)/pi of the exact directional albedo E_F = A (1 + r G/pi), with tan sin-power terms put over one denominator.
double exactShape(double cosine)
{
    const double c = std::min(cosine, 1.0);
    const double s = std::sqrt((1.0 - c) * (1.0 + c));
    const double theta = std::atan2(s, c);
    const double tangentPart = s * c * (1.0 + s + s * s) / (1.0 + s); // tan (1 - sin^3)
    return (s * (theta - s * c) + 2.0 / 3.0 * (tangentPart - s)) / kPi;
}

// The paper's quartic fit of the same.
double fittedShape(double cosine)
{
    const double x = 1.0 - cosine;
    return 0.0571085289 * x + 0.491881867 * x * x - 0.332181442 * x * x * x + 0.0714429953 * x * x * x * x;
}

// Single scattering plus the multiple scattering that makes up for what the first loses. The lost shares 1 - E are
// differences of shapes times A r, so that A r cancels once and r = 0 needs no guard.
dvec3 eon(const ShadingPoint& point, double (*shape)(double))
{
    if (belowHorizon(point))
        return dvec3(0);
    const double r = point.perceptualRoughness;
    const double A = 1.0 / (1.0 + kGrazing * r);
    const double s = point.VoL - point.NoL * point.NoV;
    const double lobe =
        s > 0 ? 1.0 + r * s / std::max(point.NoL, point.NoV)                           // towards the light
              : (1.0 - r) + r * (2.0 * point.VoH * point.VoH - point.NoL * point.NoV); // 1 + VoL = 2 VoH^2
    const double meanAlbedo = A * (1.0 + kMean * r);
    const double lost = A * r * (kGrazing - shape(point.NoV)) * (kGrazing - shape(point.NoL)) / (kGrazing - kMean);
    const dvec3 rho = point.baseColor;
    const dvec3 rhoMultiple = rho * rho * meanAlbedo / (dvec3(1) - rho * (1.0 - meanAlbedo));
    return (rho * (A * lobe) + rhoMultiple * lost) / kPi;
}

} // namespace

// Lambert's cosine law; glTF 2.0, Appendix B.
dvec3 Fd_lambert(const ShadingPoint& point)
{
    return belowHorizon(point) ? dvec3(0) : point.baseColor / kPi;
}

// Burley 2012, section 5.3: retroreflection at grazing grows with roughness from 1/2 to 5/2 of Lambert's.
dvec3 Fd_burley(const ShadingPoint& point)
{
    if (belowHorizon(point))
        return dvec3(0);
    const double FD90 = 0.5 + 2.0 * point.perceptualRoughness * point.VoH * point.VoH;
    const double light = std::pow(1.0 - point.NoL, 5);
    const double view = std::pow(1.0 - point.NoV, 5);
    const double lightGain = (1.0 - light) + FD90 * light;
    const double viewGain = (1.0 - view) + FD90 * view;
    return point.baseColor * (lightGain * viewGain / kPi);
}

// Portsmouth, Kutz & Hill 2025, with the exact albedo.
dvec3 Fd_eon(const ShadingPoint& point)
{
    return eon(point, exactShape);
}

// The fit passes G(0) by 5e-4, so that the lost share is negative within 0.09 degrees of grazing and the sum can fall
// below zero there by 1e-4 of a Lambert: it is held at zero.
dvec3 Fd_eon_approx(const ShadingPoint& point)
{
    return glm::max(eon(point, fittedShape), dvec3(0));
}

} // namespace torrance::brdf
