#include "image/reconstruction.h"

#include "math/low_discrepancy.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace torrance {
namespace {

constexpr std::array kHarris = {0.35875, 0.48829, 0.14128, 0.01168};

} // namespace

double filterCumulative(double x)
{
    // w(x) = a0 + a1 cos(pi x/R) + a2 cos(2 pi x/R) + a3 cos(3 pi x/R): the sines vanish at both ends.
    const double t = std::clamp(x / kFilterRadius, -1.0, 1.0);
    double sum = kHarris[0] * (t + 1.0);
    for (int i = 1; i < 4; ++i)
        sum += kHarris[static_cast<std::size_t>(i)] * std::sin(i * kPi * t) / (i * kPi);
    return sum / (2.0 * kHarris[0]);
}

double filterPlace(double u)
{
    if (u == 0.5)
        return 0.0; // the centre exactly: one sample a pixel is the pixel's centre
    double low = -kFilterRadius, high = kFilterRadius;
    constexpr int kHalvings = 60; // to the last bit of a double
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (filterCumulative(middle) < u ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

std::vector<dvec2> sampleOffsets(int count)
{
    const auto n = static_cast<std::uint32_t>(std::max(count, 1));
    const double half = 0.5 / std::bit_ceil(n); // centres the radical inverse in its stratum
    std::vector<dvec2> offsets;
    for (std::uint32_t i = 0; i < n; ++i)
        offsets.emplace_back(filterPlace((i + 0.5) / n), filterPlace(radicalInverse2(i) + half));
    return offsets;
}

} // namespace torrance
