#include "brdf/condition.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

// Truncation grows as (step kappa)^2 / 6, rounding as 2^-53 / step: both are under 1e-4 for kappa to 1e6.
constexpr double kStep = 0x1p-27;

} // namespace

double conditionNumber(const std::function<dvec3(const Geometry&)>& formula, const Geometry& at)
{
    const dvec3 value = formula(at);
    Geometry moved = at;
    double* const inputs[] = {&moved.n.x, &moved.n.y, &moved.n.z, &moved.v.x, &moved.v.y,
                              &moved.v.z, &moved.l.x, &moved.l.y, &moved.l.z, &moved.perceptualRoughness};
    dvec3 kappa(0);
    for (double* const input : inputs) {
        const double x = *input;
        *input = x * (1 + kStep);
        const dvec3 above = formula(moved);
        *input = x * (1 - kStep);
        const dvec3 below = formula(moved);
        *input = x;
        for (int channel = 0; channel < 3; ++channel)
            if (value[channel] != 0)
                kappa[channel] += std::abs((above[channel] - below[channel]) / (2 * kStep * value[channel]));
    }
    return std::max({kappa.r, kappa.g, kappa.b});
}

} // namespace torrance::brdf
