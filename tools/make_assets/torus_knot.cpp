#include "make_assets/shapes.h"

#include <cmath>

namespace torrance::assets {
namespace {

/// How far apart the points are from which the curve's tangent and bend are taken.
constexpr double kStep = 1e-4;

dvec3 knot(int p, int q, double ringRadius, double torusRadius, double s)
{
    const double turn = 2.0 * kPi * s;
    const double reach = ringRadius + torusRadius * std::cos(q * turn);
    return dvec3(reach * std::cos(p * turn), reach * std::sin(p * turn), torusRadius * std::sin(q * turn));
}

} // namespace

Surface torusKnot(int p, int q, double ringRadius, double torusRadius, double tubeRadius, int columns, int rows)
{
    const auto position = [=](double u, double v) {
        // Frenet's frame: these curves bend everywhere.
        const dvec3 here = knot(p, q, ringRadius, torusRadius, v);
        const dvec3 before = knot(p, q, ringRadius, torusRadius, v - kStep);
        const dvec3 after = knot(p, q, ringRadius, torusRadius, v + kStep);
        const dvec3 along = glm::normalize(after - before);
        const dvec3 bend = after + before - 2.0 * here;
        const dvec3 normal = glm::normalize(bend - along * glm::dot(bend, along));
        const dvec3 binormal = glm::cross(along, normal);
        const double angle = 2.0 * kPi * u;
        return here + tubeRadius * (std::cos(angle) * normal - std::sin(angle) * binormal);
    };
    return surfaceFromPositions(position, columns, rows);
}

} // namespace torrance::assets
