#include "prepare/phong_prefilter.h"

#include "prepare/zonal_means.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace torrance {
namespace {

/// Side of the largest nodes over the lobe's width 1 / sqrt(s): the levels are then within 1 % of the full sum
/// (tests/unit/prepare/environment_maps.cpp). Unlike GGX's it has no tail, so nodes do not grow with the distance.
constexpr double kSideOfWidth = 0.6;
/// The same of suns, whose light in the lobe's flanks hangs on their shape.
constexpr double kExcessSideOfWidth = 0.1;
/// The largest nodes of lobes as wide as the hemisphere.
constexpr double kGreatestSide = 0.1;
/// Where the lobe ends, as a share of its peak: a sun of 1e9 out there adds a hundredth of light of radiance 1.
constexpr double kEnd = 1e-11;
/// Lobes below this exponent see suns on the horizon.
constexpr double kHorizonExponent = 20.0;

/// cos^s over q = sin^2(theta / 2), linear between its nodes: within 1e-5 of the peak (tests/unit/prepare).
class CosinePower
{
public:
    explicit CosinePower(double exponent) : end(static_cast<float>(0.5 * (1.0 - lastCosine(exponent))))
    {
        for (int i = 0; i <= kCells; ++i) {
            const double cosine = std::max(0.0, 1.0 - 2.0 * static_cast<double>(end) * i / kCells);
            nodes[static_cast<std::size_t>(i)] = static_cast<float>(std::pow(cosine, exponent));
        }
        cellsPerUnit = static_cast<float>(kCells) / end;
    }

    TORRANCE_INLINE Lanes operator()(const Lanes& q) const
    {
        const Lanes last = Lanes{} + static_cast<float>(kCells);
        Lanes x = q * cellsPerUnit;
        x = x < last ? x : last;
        IntLanes cell = __builtin_convertvector(x, IntLanes);
        cell = cell < kCells ? cell : IntLanes{} + (kCells - 1);
        Lanes left, right;
        for (int i = 0; i < kLanes; ++i) {
            left[i] = nodes[static_cast<std::size_t>(cell[i])];
            right[i] = nodes[static_cast<std::size_t>(cell[i]) + 1];
        }
        return left + (right - left) * (x - __builtin_convertvector(cell, Lanes));
    }

    float chord() const { return 2.0f * std::sqrt(end); }

private:
    static double lastCosine(double exponent) { return exponent > 0.0 ? std::pow(kEnd, 1.0 / exponent) : 0.0; }

    static constexpr int kCells = 4096;
    float end; // q
    float cellsPerUnit = 0.0f;
    std::array<float, kCells + 1> nodes{};
};

struct Whole
{
    const CosinePower& power;

    TORRANCE_INLINE Lanes operator()(const Receivers& receivers, const CubeNode& point) const
    {
        return power(receivers.halfSine2(point));
    }
};

struct CutByHorizon
{
    const CosinePower& power;

    TORRANCE_INLINE Lanes operator()(const Receivers& receivers, const CubeNode& point) const
    {
        const Lanes none = {}, whole = none + 1.0f, q = receivers.halfSine2(point);
        Lanes risen = 0.5f + (0.5f - q) / point.spread; // the share of the patch that is above
        risen = risen > none ? risen : none;
        risen = risen < whole ? risen : whole;
        return power(q) * risen;
    }
};

} // namespace

std::vector<float> phongLevel(const CubeTree& base, const CubeTree& excess, int size, double exponent)
{
    const CosinePower power(exponent);
    const double width = 1.0 / std::sqrt(std::max(exponent, 1.0));
    const Opening ofBaseNodes = {.width = 4.0f, // greatestSide decides alone
                                 .greatestSide = static_cast<float>(std::min(kGreatestSide, kSideOfWidth * width)),
                                 .leavesAtHorizon = false,
                                 .end = power.chord()};
    Opening ofExcessNodes = ofBaseNodes;
    ofExcessNodes.greatestSide = static_cast<float>(std::min(kGreatestSide, kExcessSideOfWidth * width));
    ofExcessNodes.leavesAtHorizon = exponent < kHorizonExponent;
    const ZonalKernel<Whole, CutByHorizon> kernel = {{power}, {power}, 2.0 * kPi / (exponent + 1.0)};
    return zonalMeans(base, excess, size, {ofBaseNodes, ofExcessNodes}, kernel);
}

} // namespace torrance
