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
        const double ring = v <= 0.0 || v >= 1.0 ? 0.0 : std::cos(up); // poles are points
        const double s = signedPower(ring, exponentUp);
        const dvec3 position =
            radii * dvec3(s * signedPower(std::sin(around), exponentAround), signedPower(std::sin(up), exponentUp),
                          s * signedPower(std::cos(around), exponentAround));
        const double n = signedPower(ring, 2.0 - exponentUp);
        const dvec3 normal = glm::normalize(dvec3(n * signedPower(std::sin(around), 2.0 - exponentAround),
                                                  signedPower(std::sin(up), 2.0 - exponentUp),
                                                  n * signedPower(std::cos(around), 2.0 - exponentAround)) /
                                            radii);
        // Going around is level, so it is along the level line across the normal.
        const dvec3 tangent = ring > 0.0 ? glm::normalize(dvec3(normal.z, 0.0, -normal.x))
                                         : dvec3(std::cos(around), 0.0, -std::sin(around));
        return SurfacePoint{position, normal, tangent, dvec2(u, v)};
    };
    return {at, evenSteps(columns), evenSteps(rows)};
}

} // namespace torrance::assets
