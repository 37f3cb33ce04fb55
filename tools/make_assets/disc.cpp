#include "make_assets/shapes.h"

#include <cmath>

namespace torrance::assets {
namespace {

/// Shirley and Chiu 1997, "A Low Distortion Map Between Disk and Square": a, b in [-1, 1].
dvec2 discFromSquare(double a, double b)
{
    if (a == 0.0 && b == 0.0)
        return dvec2(0.0);
    if (std::abs(a) > std::abs(b))
        return a * dvec2(std::cos(kPi / 4.0 * b / a), std::sin(kPi / 4.0 * b / a));
    return b * dvec2(std::sin(kPi / 4.0 * a / b), std::cos(kPi / 4.0 * a / b));
}

} // namespace

Surface disc(double radius, int columns)
{
    const auto at = [radius](double u, double v) {
        const dvec2 place = radius * discFromSquare(2.0 * u - 1.0, 2.0 * v - 1.0);
        return SurfacePoint{dvec3(place.x, 0.0, place.y), dvec3(0.0, 1.0, 0.0), dvec3(1.0, 0.0, 0.0), place};
    };
    return {at, evenSteps(columns), evenSteps(columns)};
}

} // namespace torrance::assets
