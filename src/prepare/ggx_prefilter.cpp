#include "prepare/ggx_prefilter.h"

#include "prepare/zonal_means.h"

#include <cmath>

namespace torrance {
namespace {

/// Angle of the largest nodes for alpha = 1, whose kernel is cut off by the horizon while it is still large. Narrower
/// lobes have little light out there, and larger nodes do.
constexpr double kGreatestSide = 0.1;
/// Lobes wider than this see suns on the horizon bright enough for the sun's shape to count.
constexpr double kHorizonAlpha = 0.3;

/// cos / (alpha^2 + (1 - alpha^2) sin^2(theta / 2))^2.
struct Whole
{
    float a2, rest; // rest = 1 - a2

    TORRANCE_INLINE Lanes operator()(const Receivers& receivers, const CubeNode& point) const
    {
        const Lanes q = receivers.halfSine2(point), d = a2 + rest * q;
        return (1.0f - 2.0f * q) / (d * d);
    }
};

/// The same by the cosine, as sin^2(theta / 2) = (1 - cos) / 2, of a patch that the horizon may cut.
struct AtHorizon
{
    float A, B; // (1 + alpha^2) / 2, (1 - alpha^2) / 2

    TORRANCE_INLINE Lanes operator()(const Receivers& receivers, const CubeNode& point) const
    {
        const Lanes cosine = receivers.cosine(point), d = A - B * cosine;
        return clampedCosine(cosine, point.spread) / (d * d);
    }
};

ZonalKernel<Whole, AtHorizon> ggxKernel(double alpha)
{
    const double a2 = alpha * alpha;
    return {{static_cast<float>(a2), static_cast<float>(1.0 - a2)},
            {static_cast<float>(0.5 * (1.0 + a2)), static_cast<float>(0.5 * (1.0 - a2))},
            ggxKernelIntegral(alpha)};
}

} // namespace

double ggxKernelIntegral(double alpha)
{
    // 2 pi times the integral over x = cos(theta) in [0, 1] of x / (A - B x)^2, A = (1 + alpha^2) / 2, B = (1 -
    // alpha^2) / 2.
    const double a2 = alpha * alpha;
    const double A = 0.5 * (1.0 + a2), B = 0.5 * (1.0 - a2);
    if (B < 1e-4) // alpha near 1, where the closed form cancels: the first two terms of the series in B
        return 2.0 * kPi * (0.5 / (A * A) + 2.0 * B / (3.0 * A * A * A));
    return 2.0 * kPi * (std::log(a2 / A) + A / a2 - 1.0) / (B * B);
}

std::vector<float> prefilterLevel(const CubeTree& base, const CubeTree& excess, int size, double alpha)
{
    const Opening ofBaseNodes = {
        .width = static_cast<float>(2.0 * alpha), // theta at which the lobe's denominator has doubled
        .greatestSide = static_cast<float>(kGreatestSide / std::sqrt(alpha)),
        .leavesAtHorizon = false};
    Opening ofExcessNodes = ofBaseNodes;
    ofExcessNodes.leavesAtHorizon = alpha > kHorizonAlpha;
    return zonalMeans(base, excess, size, {ofBaseNodes, ofExcessNodes}, ggxKernel(alpha));
}

} // namespace torrance
