#include "brdf/irradiance_window.h"

#include "math/latlong.h"
#include "math/spherical_harmonics.h"

#include <algorithm>
#include <vector>

namespace torrance::brdf {
namespace {

constexpr int kRows = 32; // of directions: 0.1 rad apart, a twentieth of the shortest wave of band 2

std::array<dvec3, 9> weighed(const std::array<dvec3, 9>& harmonics, double lambda)
{
    std::array<dvec3, 9> result;
    for (std::size_t i = 0; i < 9; ++i) {
        const double l = i == 0 ? 0.0 : i < 4 ? 1.0 : 2.0;
        const double laplacian = l * (l + 1.0);
        result[i] = harmonics[i] / (1.0 + lambda * laplacian * laplacian);
    }
    return result;
}

const std::vector<Sh9>& directions()
{
    static const std::vector<Sh9> bases = [] {
        std::vector<Sh9> list;
        for (int y = 0; y < kRows; ++y)
            for (int x = 0; x < 2 * kRows; ++x)
                list.push_back(shBasis(directionFromLatLong({(x + 0.5) / (2 * kRows), (y + 0.5) / kRows})));
        return list;
    }();
    return bases;
}

bool swingsBelowZero(const std::array<dvec3, 9>& harmonics)
{
    return std::ranges::any_of(directions(), [&](const Sh9& basis) {
        dvec3 sum(0);
        for (std::size_t i = 0; i < 9; ++i)
            sum += basis[i] * harmonics[i];
        return std::min({sum.r, sum.g, sum.b}) < 0;
    });
}

} // namespace

std::array<dvec3, 9> windowedHarmonics(const std::array<dvec3, 9>& harmonics)
{
    if (!swingsBelowZero(harmonics))
        return harmonics;
    // At the upper end the bands are gone: what is left is the mean, which light makes positive.
    constexpr double kMost = 1e6;
    constexpr int kHalvings = 60;
    double low = 0, high = kMost;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (swingsBelowZero(weighed(harmonics, middle)) ? low : high) = middle;
    }
    return weighed(harmonics, high);
}

} // namespace torrance::brdf
