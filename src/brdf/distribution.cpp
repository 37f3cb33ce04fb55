#include "brdf/distribution.h"

#include <cmath>

namespace torrance::brdf {

// Trowbridge & Reitz 1975: the curvature of an ellipsoid of revolution with semi-axis ratio alpha, 1 / (pi a^2
// (sin^2/a^2 + cos^2)^2), which is Walter et al. 2007, eq. 33, without its tangent.
double D_ggx(const ShadingPoint& point)
{
    const double a2 = point.alpha * point.alpha;
    const double ellipse = point.sin2H / a2 + point.NoH * point.NoH;
    return 1.0 / (kPi * a2 * ellipse * ellipse);
}

// The same from NoH alone. The guard keeps the quotient finite where the sum cancels to nothing, which double does at
// NoH = 1 only for alpha below 1e-8.
double D_ggx_textbook(const ShadingPoint& point)
{
    const double a2 = point.alpha * point.alpha;
    const double d = point.NoH * point.NoH * (a2 - 1.0) + 1.0;
    return a2 / (kPi * d * d + kLeastDenominator);
}

// Walter et al. 2007, eq. 25: slopes of normal distribution, variance alpha^2 / 2. At NoH = 0 the exponential wins over
// 1/cos^4.
double D_beckmann(const ShadingPoint& point)
{
    const double cos2 = point.NoH * point.NoH;
    if (cos2 <= 0)
        return 0;
    const double secant2 = 1.0 / cos2;
    const double slope2 = point.sin2H * secant2 / (point.alpha * point.alpha);
    const double density = std::exp(-slope2);
    return density > 0 ? density * secant2 * secant2 / (kPi * point.alpha * point.alpha) : 0.0;
}

// Walter et al. 2007, eq. 30, with the exponent p = 2/a^2 - 2 that gives Beckmann's peak. log NoH comes from sin^2
// where NoH is near 1 and its last digits are all there is.
double D_blinn(const ShadingPoint& point)
{
    const double p = 2.0 / (point.alpha * point.alpha) - 2.0;
    if (p <= 0)
        return 1.0 / kPi; // alpha = 1: no lobe
    const double logNoH = point.sin2H < 0.5 ? 0.5 * std::log1p(-point.sin2H) : std::log(std::abs(point.NoH));
    return (p + 2.0) / (2.0 * kPi) * std::exp(p * logNoH);
}

// Burley 2012, appendix B, eq. 13: the ellipsoid with one semi-axis ratio along the tangent and another across it. A
// sum of squares: nothing cancels.
double D_ggx_aniso(const ShadingPoint& point)
{
    const double along = point.ToH / point.alphaT, across = point.BoH / point.alphaB;
    const double ellipsoid = along * along + across * across + point.NoH * point.NoH;
    return 1.0 / (kPi * point.alphaT * point.alphaB * ellipsoid * ellipsoid);
}

} // namespace torrance::brdf
