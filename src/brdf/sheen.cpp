#include "brdf/sheen.h"

#include <cmath>

namespace torrance::brdf {
namespace {

// Conty & Kulla 2017, section 2, the "Charlie" distribution: (2 + 1/alpha) sin^(1/alpha) / (2 pi). The sine's logarithm
// comes from whichever of sin2H and NoH keeps more of its digits.
double charlieDistribution(const ShadingPoint& point)
{
    const double logSine = point.sin2H < 0.5 ? 0.5 * std::log(point.sin2H) : 0.5 * std::log1p(-point.NoH * point.NoH);
    return (2.0 + 1.0 / point.alpha) * std::exp(logSine / point.alpha) / (2.0 * kPi);
}

// Conty & Kulla 2017, section 3: the fit L(x) = a / (1 + b x^c) + d x + e of log Lambda, its parameters blended by
// (1 - alpha)^2 from those of alpha = 1 to those of alpha = 0.
double fitOfLogLambda(double x, double alpha)
{
    struct Parameters
    {
        double a, b, c, d, e;
    };
    constexpr Parameters kRough = {21.5473, 3.82987, 0.19823, -1.97760, -4.32054};
    constexpr Parameters kSmooth = {25.3245, 3.32435, 0.16801, -1.27393, -4.85967};
    const double smooth = (1.0 - alpha) * (1.0 - alpha);
    const auto blend = [&](double Parameters::*p) { return std::lerp(kRough.*p, kSmooth.*p, smooth); };
    return blend(&Parameters::a) / (1.0 + blend(&Parameters::b) * std::pow(x, blend(&Parameters::c))) +
           blend(&Parameters::d) * x + blend(&Parameters::e);
}

// Fitted for grazing angles; the other half is its point reflection in (1/2, L(1/2)).
double charlieLambda(double cosine, double alpha)
{
    return cosine < 0.5 ? std::exp(fitOfLogLambda(cosine, alpha))
                        : std::exp(2.0 * fitOfLogLambda(0.5, alpha) - fitOfLogLambda(1.0 - cosine, alpha));
}

} // namespace

double S_charlie(const ShadingPoint& point)
{
    if (point.NoV <= 0 || point.NoL <= 0)
        return 0;
    const double masking = 1.0 + charlieLambda(point.NoV, point.alpha) + charlieLambda(point.NoL, point.alpha);
    return charlieDistribution(point) / (4.0 * point.NoV * point.NoL * masking + kLeastDenominator);
}

// Ashikhmin & Premoze 2007: the denominator 4 (NoL + NoV - NoL NoV) instead of a visibility term.
double S_ashikhmin(const ShadingPoint& point)
{
    if (point.NoV <= 0 || point.NoL <= 0)
        return 0;
    return charlieDistribution(point) / (4.0 * (point.NoL + point.NoV - point.NoL * point.NoV));
}

} // namespace torrance::brdf
