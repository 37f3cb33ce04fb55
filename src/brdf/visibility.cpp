#include "brdf/visibility.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

bool belowHorizon(const ShadingPoint& point)
{
    return point.NoV <= 0 || point.NoL <= 0;
}

// cos (1 + 2 Lambda(cos)) of GGX, from Lambda = (sqrt(1 + a^2 tan^2) - 1) / 2 (Heitz 2014, eq. 72): the secant is
// multiplied in, so that nothing grows towards grazing.
double cosTimesOnePlusTwoLambda(double cosine, double alpha)
{
    const double sine2 = (1.0 - cosine) * (1.0 + cosine);
    return std::sqrt(cosine * cosine + alpha * alpha * sine2);
}

// G of a product of two Schlick terms c / (c (1 - k) + k), over 4 NoV NoL.
double schlickProduct(const ShadingPoint& point, double k)
{
    const double masking = point.NoV + k * (1.0 - point.NoV);
    const double shadowing = point.NoL + k * (1.0 - point.NoL);
    return 0.25 / (masking * shadowing);
}

} // namespace

// Heitz 2014, eq. 99: G = 1 / (1 + Lambda(v) + Lambda(l)).
double V_smith_corr(const ShadingPoint& point)
{
    if (belowHorizon(point))
        return 0;
    const double view = cosTimesOnePlusTwoLambda(std::min(point.NoV, 1.0), point.alpha);
    const double light = cosTimesOnePlusTwoLambda(std::min(point.NoL, 1.0), point.alpha);
    return 0.5 / (point.NoL * view + point.NoV * light + kLeastDenominator);
}

// Walter et al. 2007, eqs. 23 and 34: G = G1(v) G1(l), G1 = 2 / (1 + sqrt(1 + a^2 tan^2)).
double V_smith_uncorr(const ShadingPoint& point)
{
    if (belowHorizon(point))
        return 0;
    const double view = point.NoV + cosTimesOnePlusTwoLambda(std::min(point.NoV, 1.0), point.alpha);
    const double light = point.NoL + cosTimesOnePlusTwoLambda(std::min(point.NoL, 1.0), point.alpha);
    return 1.0 / view / light;
}

// Hammon 2017: the square roots of the correlated form replaced by a blend in alpha.
double V_hammon(const ShadingPoint& point)
{
    if (belowHorizon(point))
        return 0;
    const double smooth = 2.0 * point.NoL * point.NoV;
    const double rough = point.NoL + point.NoV;
    return 0.5 / (smooth * (1.0 - point.alpha) + rough * point.alpha + kLeastDenominator);
}

// Schlick 1994, eq. 19, with k = a/2 (Karis 2013).
double V_schlick_half(const ShadingPoint& point)
{
    return belowHorizon(point) ? 0.0 : schlickProduct(point, 0.5 * point.alpha);
}

// Karis 2013, eq. 4: k = (r + 1)^2 / 8.
double V_schlick_direct(const ShadingPoint& point)
{
    const double remapped = 0.5 * (point.perceptualRoughness + 1.0);
    return belowHorizon(point) ? 0.0 : schlickProduct(point, 0.5 * remapped * remapped);
}

// Cook & Torrance 1982: G = min(1, 2 NoH NoV / VoH, 2 NoH NoL / VoH); each is divided by 4 NoV NoL before the least is
// taken.
double V_vcavity(const ShadingPoint& point)
{
    if (belowHorizon(point))
        return 0;
    const double unblocked = 0.25 / (point.NoV * point.NoL + kLeastDenominator);
    const double masked = 0.5 * point.NoH / (point.VoH * point.NoL + kLeastDenominator);
    const double shadowed = 0.5 * point.NoH / (point.VoH * point.NoV + kLeastDenominator);
    return std::min({unblocked, masked, shadowed});
}

// Kelemen & Szirmay-Kalos 2001: G / (NoV NoL) taken as 1 / VoH^2. With VoH^2 = (1 + VoL) / 2 where no rounding is at
// stake, but here VoH is what is given.
double V_kelemen(const ShadingPoint& point)
{
    return belowHorizon(point) ? 0.0 : 0.25 / (point.VoH * point.VoH + kLeastDenominator);
}

// Neumann et al. 1999: 1 / max(NoL, NoV).
double V_neumann(const ShadingPoint& point)
{
    return belowHorizon(point)
               ? 0.0
               : std::min(0.25 / (point.NoV + kLeastDenominator), 0.25 / (point.NoL + kLeastDenominator));
}

// G = NoV NoL, so that the denominator goes: Hoffman's course notes.
double V_implicit(const ShadingPoint& point)
{
    return belowHorizon(point) ? 0.0 : 0.25;
}

} // namespace torrance::brdf
