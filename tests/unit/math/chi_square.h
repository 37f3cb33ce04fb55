// Whether samples follow a density: Pearson's chi-square test over the cells of a grid, as pbrt and Mitsuba hold their
// samplers to account. Samples come from a generator of another kind than the program's own sequences, because the test
// needs independent ones.
#pragma once

#include "math/quadrature.h"
#include "math/vector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace torrance::test {

/// Seeds are fixed. A right sampler would fail a family of tests for one seed in 1 / kFamilyLevel.
inline constexpr double kFamilyLevel = 1e-4;

/// Probability that chi-square with `freedom` degrees is at least x: the upper incomplete gamma function Q(freedom / 2,
/// x / 2), by its series or its continued fraction (Abramowitz & Stegun 1964, 6.5.29 and 6.5.31).
inline double chiSquareTail(double x, int freedom)
{
    const double a = 0.5 * freedom, y = 0.5 * x;
    const double scale = std::exp(a * std::log(y) - y - std::lgamma(a));
    if (y < a + 1.0) {
        double term = 1.0 / a, sum = term;
        for (int n = 1; term > 1e-16 * sum; ++n)
            sum += term *= y / (a + n);
        return 1.0 - scale * sum;
    }
    double b = y + 1.0 - a, c = 1e300, d = 1.0 / b, h = d;
    for (int i = 1; i < 10000; ++i) {
        const double an = -i * (i - a);
        b += 2.0;
        d = 1.0 / (an * d + b);
        c = b + an / c;
        h *= d * c;
        if (std::abs(d * c - 1.0) < 1e-15)
            break;
    }
    return scale * h;
}

/// p of the counts where `expected` is the truth. Cells that expect fewer than five are counted as one, for there the
/// normal limit does not hold; a sample where none is expected gives 0.
inline double chiSquareLikelihood(const std::vector<double>& expected, const std::vector<double>& counts)
{
    double statistic = 0.0, poolExpected = 0.0, poolCount = 0.0;
    int cells = 0;
    const auto add = [&](double e, double n) {
        statistic += (n - e) * (n - e) / e;
        ++cells;
    };
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (expected[i] >= 5.0)
            add(expected[i], counts[i]);
        else {
            poolExpected += expected[i];
            poolCount += counts[i];
        }
    if (poolExpected >= 5.0)
        add(poolExpected, poolCount);
    else if (poolCount > poolExpected + 30.0) // a Poisson count of mean 5 passes 35 once in 1e17
        return 0.0;
    return chiSquareTail(statistic, cells - 1);
}

/// Cells of equal polar and azimuthal angles over the sphere, the pole along +Z.
struct SphereCells
{
    int rows = 24; // even: the horizon is an edge
    int columns = 32;

    std::size_t count() const { return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns); }
    std::size_t of(const dvec3& d) const
    {
        const double theta = std::atan2(std::hypot(d.x, d.y), d.z), phi = std::atan2(d.y, d.x) + kPi;
        const int row = std::min(static_cast<int>(theta / kPi * rows), rows - 1);
        const int column = std::min(static_cast<int>(phi / (2.0 * kPi) * columns), columns - 1);
        return static_cast<std::size_t>(row * columns + column);
    }

    /// The integral of a density (1/sr) over each cell.
    std::vector<double> integrals(const std::function<double(const dvec3&)>& density) const
    {
        const QuadratureRule rule = gaussLegendre(32, 0.0, 1.0);
        std::vector<double> result;
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column)
                result.push_back(integrate(rule,
                                           [&](double s) {
                                               const double theta = kPi * (row + s) / rows, sine = std::sin(theta);
                                               return integrate(rule, [&](double t) {
                                                   const double phi = 2.0 * kPi * (column + t) / columns - kPi;
                                                   return sine * density(dvec3(sine * std::cos(phi),
                                                                               sine * std::sin(phi), std::cos(theta)));
                                               });
                                           }) *
                                 (kPi / rows) * (2.0 * kPi / columns));
        return result;
    }
};

struct SamplerJudgement
{
    double likelihood = 0.0;
    double integral = 0.0; // of the density over the region where it is given
};

/// `sample` draws a direction from a point of the square. `density` is its density where `counted` holds; all other
/// samples together are expected to be the rest.
inline SamplerJudgement judgeSampler(const std::function<dvec3(const dvec2&)>& sample,
                                     const std::function<double(const dvec3&)>& density,
                                     const std::function<bool(const dvec3&)>& counted, int samples, unsigned seed)
{
    const SphereCells cells;
    std::vector<double> expected = cells.integrals([&](const dvec3& d) { return counted(d) ? density(d) : 0.0; });
    SamplerJudgement judgement;
    for (double& cell : expected) {
        judgement.integral += cell;
        cell *= samples;
    }
    expected.push_back(std::max(0.0, (1.0 - judgement.integral) * samples));
    std::vector<double> counts(expected.size(), 0.0);
    std::mt19937_64 generator(seed);
    const auto uniform = [&] { return (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53; };
    for (int i = 0; i < samples; ++i) {
        const double x = uniform(), y = uniform();
        const dvec3 d = sample({x, y});
        counts[counted(d) ? cells.of(d) : cells.count()] += 1.0;
    }
    judgement.likelihood = chiSquareLikelihood(expected, counts);
    return judgement;
}

} // namespace torrance::test
