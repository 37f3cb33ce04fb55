#include "measure/student.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

/// The continued fraction of Abramowitz & Stegun 26.5.8 by Lentz's method; converges fast for x < (a + 1) / (a + b +
/// 2).
double betaFraction(double a, double b, double x)
{
    constexpr double kTiny = 1e-300; // stands in for a denominator of exactly 0
    constexpr double kPrecise = 1e-15;
    constexpr int kMostSteps = 100000;
    const auto apart = [](double value) { return std::abs(value) < kTiny ? kTiny : value; };
    double c = 1.0, d = 1.0 / apart(1.0 - (a + b) * x / (a + 1.0)), fraction = d;
    for (int m = 1; m < kMostSteps; ++m) {
        const double even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        d = 1.0 / apart(1.0 + even * d);
        c = apart(1.0 + even / c);
        fraction *= d * c;
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        d = 1.0 / apart(1.0 + odd * d);
        c = apart(1.0 + odd / c);
        fraction *= d * c;
        if (std::abs(d * c - 1.0) < kPrecise)
            break;
    }
    return fraction;
}

/// I_x(a, b), 0 <= x <= 1; y = 1 - x is given apart, for it may be tiny.
double regularizedBeta(double a, double b, double x, double y)
{
    if (!(x > 0.0))
        return 0.0;
    if (!(y > 0.0))
        return 1.0;
    const double front =
        std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log(y));
    return x < (a + 1.0) / (a + b + 2.0) ? front * betaFraction(a, b, x) / a : 1.0 - front * betaFraction(b, a, y) / b;
}

} // namespace

double studentCumulative(double t, double degrees)
{
    const double square = t * t;
    const double tails =
        regularizedBeta(0.5 * degrees, 0.5, degrees / (degrees + square), square / (degrees + square)); // P(|T| > |t|)
    return t < 0.0 ? 0.5 * tails : 1.0 - 0.5 * tails;
}

double student95(double degrees)
{
    constexpr double kNormal95 = 1.959963984540054; // of infinitely many degrees
    constexpr double kAsNormal = 1e7;               // the difference is below 1e-6 from here on
    if (degrees > kAsNormal)
        return kNormal95;
    const double known = std::max(degrees, kLeastDegrees);
    double low = kNormal95, high = 13.0; // 12.706 of one degree
    while (high - low > 1e-12 * high) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high)
            break;
        (studentCumulative(middle, known) < 0.975 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace torrance
