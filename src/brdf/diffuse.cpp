#include "brdf/diffuse.h"
#include "math/powers.h"

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
    const double light = fifthPower(1.0 - point.NoL);
    const double view = fifthPower(1.0 - point.NoV);
    const double lightGain = (1.0 - light) + FD90 * light;
    const double viewGain = (1.0 - view) + FD90 * view;
    return point.baseColor * (lightGain * viewGain / kPi);
}

// Lagarde & de Rousiers 2014, section 3.1.3: Burley's with another reflectance at grazing, scaled so that it gains
// nothing at a normal view.
dvec3 Fd_burley_renormalised(const ShadingPoint& point)
{
    if (belowHorizon(point))
        return dvec3(0);
    const double r = point.perceptualRoughness;
    const double FD90 = r * (0.5 + 2.0 * point.VoH * point.VoH);
    const double light = fifthPower(1.0 - point.NoL);
    const double view = fifthPower(1.0 - point.NoV);
    const double factor = (1.0 - r) + r / 1.51;
    const double gain = ((1.0 - light) + FD90 * light) * ((1.0 - view) + FD90 * view);
    return point.baseColor * (factor * gain / kPi);
}

// Oren & Nayar 1994, the qualitative model, with sigma = r radians. cos(phi) sin(alpha) tan(beta), alpha the greater
// and beta the lesser of both angles, is cos(phi) sin sin over the greater cosine: no tangent is left to grow.
dvec3 Fd_oren_nayar(const ShadingPoint& point)
{
    if (belowHorizon(point))
        return dvec3(0);
    const double variance = point.perceptualRoughness * point.perceptualRoughness;
    const double A = 1.0 - 0.5 * variance / (variance + 0.33);
    const double B = 0.45 * variance / (variance + 0.09);
    const double s = std::max(0.0, point.VoL - point.NoL * point.NoV);
    return point.baseColor * ((A + B * s / std::max(point.NoL, point.NoV)) / kPi);
}

// Fujii's improvement of the same, with sigma = r: away from the light s is not cut but kept undivided.
dvec3 Fd_fujii(const ShadingPoint& point)
{
    if (belowHorizon(point))
        return dvec3(0);
    const double r = point.perceptualRoughness;
    const double A = 1.0 / (kPi + (0.5 * kPi - 2.0 / 3.0) * r);
    const double s = point.VoL - point.NoL * point.NoV;
    const double lobe = s > 0 ? 1.0 + r * s / std::max(point.NoL, point.NoV)
                              : (1.0 - r) + r * (2.0 * point.VoH * point.VoH - point.NoL * point.NoV);
    return point.baseColor * (A * lobe);
}

// Hammon 2017: a fit to the diffuse light of a GGX surface with Smith's masking; the term of the base colour's square
// is the light that meets several facets. NoH of the denominator vanishes with both cosines.
dvec3 Fd_hammon_diffuse(const ShadingPoint& point)
{
    if (belowHorizon(point))
        return dvec3(0);
    const double facing = point.VoH * point.VoH; // (1 + VoL) / 2
    const double rough = facing * (0.9 - 0.4 * facing) * (1.0 + 0.5 / (point.NoH + kLeastDenominator));
    const auto transmitted = [](double cosine) { return -std::expm1(5.0 * std::log1p(-std::min(cosine, 1.0))); };
    const double smooth = 1.05 * transmitted(point.NoL) * transmitted(point.NoV);
    const double single = (smooth * (1.0 - point.alpha) + rough * point.alpha) / kPi;
    return point.baseColor * (dvec3(single) + point.baseColor * (0.1159 * point.alpha));
}

// Chan 2018: a fit to simulated diffuse light of GGX surfaces, by a gloss g with alpha^2 = 2 / (1 + 2^(18 g)), held
// within [0, 1]: alpha below 0.0028 counts as that. The bump is negative for g in (0.71, 1), and at grazing it can pass
// the rest by 0.07 of a Lambert: the sum is held at zero.
dvec3 Fd_chan(const ShadingPoint& point)
{
    if (belowHorizon(point))
        return dvec3(0);
    const double a2 = point.alpha * point.alpha;
    const double g = std::clamp(std::log1p(2.0 * (1.0 - a2) / a2) / (18.0 * std::log(2.0)), 0.0, 1.0);
    const double rough = point.VoH + fifthPower(point.oneLessVoH);
    const double smooth = (1.0 - 0.75 * fifthPower(1.0 - point.NoV)) * (1.0 - 0.75 * fifthPower(1.0 - point.NoL));
    const double blend = std::clamp(2.2 * g - 0.5, 0.0, 1.0);
    const double width = std::max(73.2 * g - 21.2, 8.9);
    const double bump = (34.5 * g * g - 59.0 * g + 24.5) * point.VoH * std::exp2(-width * std::sqrt(point.NoH));
    return point.baseColor * (std::max(0.0, rough * (1.0 - blend) + smooth * blend + bump) / kPi);
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
