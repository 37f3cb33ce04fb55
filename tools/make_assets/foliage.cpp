#include "make_assets/shapes.h"

#include <cmath>

namespace torrance::assets {
namespace {

dvec3 bezier(const std::array<dvec3, 4>& p, double t)
{
    const double s = 1.0 - t;
    return s * s * s * p[0] + 3.0 * s * s * t * p[1] + 3.0 * s * t * t * p[2] + t * t * t * p[3];
}

} // namespace

Surface stem(const std::array<dvec3, 4>& control, double startRadius, double endRadius, int columns, int rows)
{
    const auto position = [=](double u, double v) {
        constexpr double kStep = 1e-4;
        const double t = 1.0 - v;
        const dvec3 along = glm::normalize(bezier(control, t + kStep) - bezier(control, t - kStep));
        const dvec3 right = glm::normalize(glm::cross(along, dvec3(0.0, 0.0, 1.0)));
        const dvec3 front = glm::cross(right, along);
        const double angle = 2.0 * kPi * u;
        const double radius = glm::mix(startRadius, endRadius, t);
        return bezier(control, t) + radius * (std::sin(angle) * right + std::cos(angle) * front);
    };
    return surfaceFromPositions(position, columns, rows);
}

Surface leaf(const dvec3& root, const dvec3& direction, const dvec3& face, double length, double width, double curl)
{
    const dvec3 along = glm::normalize(direction);
    const dvec3 right = glm::normalize(glm::cross(along, face));
    const dvec3 out = glm::cross(right, along);
    const auto position = [=](double u, double v) {
        const double t = 1.0 - v;
        const double across = u - 0.5;
        // Bent down towards the tip, and cupped a little about the midrib.
        const double lift = width * 0.5 * across * across * 2.0 - curl * length * t * t;
        return root + along * (length * t * (1.0 - 0.3 * curl * t)) + right * (width * across) + out * lift;
    };
    return surfaceFromPositions(position, 6, 10);
}

} // namespace torrance::assets
