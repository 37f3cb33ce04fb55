#include "measure/ratio_estimate.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace torrance {
namespace {

struct Totals
{
    double numerator = 0.0, denominator = 0.0;
};

Totals totalsOf(std::span<const RatioStratum> strata)
{
    Totals totals;
    for (const RatioStratum& stratum : strata)
        for (const RatioUnit& unit : stratum.units) {
            const double weight = stratum.population / static_cast<double>(stratum.units.size());
            totals.numerator += weight * unit.numerator;
            totals.denominator += weight * unit.denominator;
        }
    return totals;
}

/// A variance that is a sum of parts, each known to some degrees of freedom.
struct VarianceSum
{
    double variance = 0.0;
    double spread = 0.0; // sum of part^2 / degrees

    void add(double part, double degrees)
    {
        variance += part;
        spread += part * part / degrees;
    }
    double degrees() const
    {
        return spread > 0.0 ? variance * variance / spread : std::numeric_limits<double>::infinity();
    }
};

/// Of the sample's residuals, unbiased.
double residualVariance(const RatioStratum& stratum, double ratio)
{
    const auto n = static_cast<double>(stratum.units.size());
    double sum = 0.0, squares = 0.0;
    for (const RatioUnit& unit : stratum.units)
        sum += unit.numerator - ratio * unit.denominator;
    for (const RatioUnit& unit : stratum.units) {
        const double e = unit.numerator - ratio * unit.denominator - sum / n;
        squares += e * e;
    }
    return squares / (n - 1.0);
}

void addStratum(const RatioStratum& stratum, double ratio, VarianceSum& total)
{
    const double N = stratum.population;
    const auto n = static_cast<double>(stratum.units.size());
    assert(n >= 1.0 && n <= N && (n >= 2.0 || n == N));
    if (n < N)
        total.add(N * N * (1.0 - n / N) * residualVariance(stratum, ratio) / n, n - 1.0);
    for (const RatioUnit& unit : stratum.units) {
        const double noise =
            unit.numeratorVariance - 2.0 * ratio * unit.covariance + ratio * ratio * unit.denominatorVariance;
        total.add(N / n * noise, kNoiseDegrees);
    }
}

} // namespace

RatioEstimate estimateRatio(std::span<const RatioStratum> strata)
{
    const Totals totals = totalsOf(strata);
    if (totals.numerator == 0.0 && totals.denominator == 0.0)
        return {0.0, 0.0, std::numeric_limits<double>::infinity()};
    const double ratio = totals.numerator / totals.denominator;
    if (!std::isfinite(ratio)) // something is not finite, or the light is none
        return {ratio, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    VarianceSum variance;
    for (const RatioStratum& stratum : strata)
        addStratum(stratum, ratio, variance);
    return {ratio, std::sqrt(variance.variance) / std::abs(totals.denominator), variance.degrees()};
}

} // namespace torrance
