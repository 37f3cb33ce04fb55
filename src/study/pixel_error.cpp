#include "study/pixel_error.h"

#include "math/norm.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torrance {
namespace {

constexpr double kCount = kReplicates;

bool isFinite(const dvec3& v)
{
    return std::isfinite(v.r) && std::isfinite(v.g) && std::isfinite(v.b);
}

double alongSigns(const dvec3& direction, const dvec3& value)
{
    double sum = 0.0;
    for (int c = 0; c < 3; ++c)
        sum += direction[c] < 0.0 ? -value[c] : direction[c] > 0.0 ? value[c] : 0.0;
    return sum;
}

double sumOf(const dvec3& v)
{
    return v.r + v.g + v.b;
}

} // namespace

double PixelError::middle() const
{
    return std::sqrt(above * std::max(below, 0.0));
}

PixelError pixelError(const Replicates& differences, const Replicates& truths)
{
    const dvec3 mean = differences.mean(), truth = truths.mean();
    PixelError error;
    error.norm = norm1(truth);
    if (!isFinite(mean)) {
        error.above = error.below = std::numeric_limits<double>::infinity();
        return error;
    }
    error.above = norm1(mean);
    for (std::size_t i = 0; i < kReplicates; ++i) {
        const dvec3 &x = differences.values[i], &c = truths.values[i];
        error.below += alongSigns(kCount * mean - x, x) / kCount;
        const double dx = alongSigns(mean, x) - error.above, dc = sumOf(c) - sumOf(truth);
        error.errorVariance += dx * dx / (kCount * (kCount - 1.0));
        error.normVariance += dc * dc / (kCount * (kCount - 1.0));
        error.covariance += dx * dc / (kCount * (kCount - 1.0));
    }
    return error;
}

PixelError pixelError(const dvec3& drawn, const Replicates& truths)
{
    Replicates differences;
    for (std::size_t i = 0; i < kReplicates; ++i)
        differences.values[i] = drawn - truths.values[i];
    return pixelError(differences, truths);
}

Bounded relativeError(const PixelError& error, double floor)
{
    const double whole = error.norm + floor;
    if (!(whole > 0.0)) // black, and all of the picture is
        return error.above > 0.0
                   ? Bounded{std::numeric_limits<double>::infinity(), 0.0, std::numeric_limits<double>::infinity()}
                   : Bounded{};
    const double value = error.middle() / whole;
    if (!std::isfinite(value))
        return {value, value, value};
    const double half = kStudent95 * (std::sqrt(error.errorVariance) + value * std::sqrt(error.normVariance)) / whole;
    return {value, std::max(0.0, std::min(value, error.below / whole) - half), error.above / whole + half};
}

} // namespace torrance
