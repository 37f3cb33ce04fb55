#include "make_assets/shapes.h"

#include <cmath>

namespace torrance::assets {

Surface sweep(double halfWidth, double front, double back, double radius, double height)
{
    const double floorLength = front - back - radius;
    const double bendLength = kPi / 2.0 * radius;
    const double wallLength = height - radius;
    const double total = floorLength + bendLength + wallLength;
    // v runs from the wall's top down to the floor's front.
    const auto at = [=](double u, double v) {
        const double x = (2.0 * u - 1.0) * halfWidth;
        const double s = v * total;
        const dvec3 tangent(1.0, 0.0, 0.0);
        const dvec2 uv(x, s);
        if (s <= wallLength)
            return SurfacePoint{dvec3(x, height - s, back), dvec3(0.0, 0.0, 1.0), tangent, uv};
        if (s >= wallLength + bendLength)
            return SurfacePoint{dvec3(x, 0.0, front - (total - s)), dvec3(0.0, 1.0, 0.0), tangent, uv};
        const double angle = (s - wallLength) / radius;
        const dvec3 normal(0.0, std::sin(angle), std::cos(angle));
        return SurfacePoint{dvec3(x, radius, back + radius) - radius * normal, normal, tangent, uv};
    };
    std::vector<double> rows = {0.0};
    for (int i = 0; i <= 24; ++i)
        rows.push_back((wallLength + bendLength * i / 24.0) / total);
    rows.push_back(1.0);
    return {at, evenSteps(1), rows};
}

} // namespace torrance::assets
