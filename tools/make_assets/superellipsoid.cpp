#include "make_assets/shapes.h"

#include <cmath>

namespace torrance::assets {
namespace {

double signedPower(double x, double exponent)
{
    return std::copysign(std::pow(std::abs(x), exponent), x);
}

} // namespace

Surface superellipsoid(const dvec3& radii, double exponentAround, double exponentUp, int columns, int rows)
{
    const auto at = [=](double u, double v) {
        const double around = 2.0 * kPi * u;
        const double up = kPi * (0.5 - v);
        const double s = signedPower(std::cos(up), exponentUp);
        const dvec3 position =
            radii * dvec3(s * signedPower(std::sin(around), exponentAround), signedPower(std::sin(up), exponentUp),
                          s * signedPower(std::cos(around), exponentAround));
        const double n = std::pow(std::max(std::cos(up), 0.0), 2.0 - exponentUp);
        const dvec3 normal =
            dvec3(n * signedPower(std::sin(around), 2.0 - exponentAround), signedPower(std::sin(up), 2.0 - exponentUp),
                  n * signedPower(std::cos(around), 2.0 - exponentAround)) /
            radii;
        return SurfacePoint{position, glm::normalize(normal), dvec3(std::cos(around), 0.0, -std::sin(around)),
                            dvec2(u, v)};
    };
    return {at, evenSteps(columns), evenSteps(rows)};
}

} // namespace torrance::assets
