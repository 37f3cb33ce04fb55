#include "measure/flip_color.h"

#include <cmath>

namespace torrance::flip {
namespace {

// Rec. 709 primaries under D65 as ratios of integers; GLM takes columns. Its rows sum to D65.
const dmat3 kXyzFromLinear = dmat3(dvec3(10135552.0 / 24577794, 2613072.0 / 12288897, 1425312.0 / 73733382),
                                   dvec3(8788810.0 / 24577794, 8788810.0 / 12288897, 8788810.0 / 73733382),
                                   dvec3(4435075.0 / 24577794, 887015.0 / 12288897, 70074185.0 / 73733382));
const dmat3 kLinearFromXyz = glm::inverse(kXyzFromLinear);
const dvec3 kWhite = kXyzFromLinear * dvec3(1.0);

// The constants of section 4.1.4: exponent, and the knee that maps 40 % of the largest distance to 95 % of the range.
constexpr double kExponent = 0.7, kKneeDistance = 0.4, kKneeValue = 0.95;

// CIELAB's cube root with its linear toe.
double compressed(double x)
{
    constexpr double kDelta = 6.0 / 29.0;
    return x > kDelta * kDelta * kDelta ? std::cbrt(x) : x / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

// Of what a display can show: green and blue lie farthest apart.
double largestDistance()
{
    return std::pow(hyab(huntLab(dvec3(0, 1, 0)), huntLab(dvec3(0, 0, 1))), kExponent);
}

} // namespace

dvec3 opponentFromLinear(const dvec3& rgb)
{
    const dvec3 t = kXyzFromLinear * rgb / kWhite;
    return {116.0 * t.y - 16.0, 500.0 * (t.x - t.y), 200.0 * (t.y - t.z)};
}

dvec3 linearFromOpponent(const dvec3& opponent)
{
    const double y = (opponent.x + 16.0) / 116.0;
    return kLinearFromXyz * (kWhite * dvec3(y + opponent.y / 500.0, y, y - opponent.z / 200.0));
}

dvec3 huntLab(const dvec3& linear)
{
    const dvec3 t = kXyzFromLinear * linear / kWhite;
    const double x = compressed(t.x), y = compressed(t.y), z = compressed(t.z);
    const double lightness = 116.0 * y - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (x - y), 0.01 * lightness * 200.0 * (y - z)};
}

double hyab(const dvec3& a, const dvec3& b)
{
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

double colorDifference(const dvec3& a, const dvec3& b)
{
    static const double largest = largestDistance();
    const double distance = std::pow(hyab(a, b), kExponent), knee = kKneeDistance * largest;
    if (distance < knee)
        return kKneeValue * distance / knee;
    return kKneeValue + (1.0 - kKneeValue) * (distance - knee) / (largest - knee);
}

} // namespace torrance::flip
