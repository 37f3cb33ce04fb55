#include "make_assets/shapes.h"

#include <cmath>
#include <utility>

namespace torrance::assets {
namespace {

/// Distances from a face's middle to its grid's lines: even angles over the rounding, one step over the flat part.
std::vector<double> faceLines(double halfSize, double radius, int steps)
{
    std::vector<double> lines;
    for (int i = steps; i >= 0; --i)
        lines.push_back(-(halfSize - radius) - radius * std::tan(kPi / 4.0 * i / steps));
    for (int i = 0; i <= steps; ++i)
        lines.push_back(halfSize - radius + radius * std::tan(kPi / 4.0 * i / steps));
    return lines;
}

std::vector<double> asParameters(const std::vector<double>& lines)
{
    std::vector<double> parameters;
    for (const double line : lines)
        parameters.push_back((line - lines.front()) / (lines.back() - lines.front()));
    return parameters;
}

Surface boxFace(const dvec3& right, const dvec3& up, const dvec3& halfSize, double radius, int steps)
{
    const dvec3 out = glm::cross(right, up);
    const double halfRight = std::abs(glm::dot(right, halfSize));
    const double halfUp = std::abs(glm::dot(up, halfSize));
    const double halfOut = std::abs(glm::dot(out, halfSize));
    const auto at = [=](double u, double v) {
        // A point of the sharp box goes to the nearest point of the round one.
        const dvec3 sharp = right * ((2.0 * u - 1.0) * halfRight) + up * ((1.0 - 2.0 * v) * halfUp) + out * halfOut;
        const dvec3 core = glm::clamp(sharp, radius - halfSize, halfSize - radius);
        const dvec3 normal = glm::normalize(sharp - core);
        return SurfacePoint{core + radius * normal, normal, glm::normalize(right - normal * glm::dot(right, normal)),
                            dvec2(u * 2.0 * halfRight, v * 2.0 * halfUp)};
    };
    return {at, asParameters(faceLines(halfRight, radius, steps)), asParameters(faceLines(halfUp, radius, steps))};
}

} // namespace

std::vector<Surface> roundedBox(const dvec3& halfSize, double radius, int stepsPerCorner)
{
    const dvec3 x(1.0, 0.0, 0.0);
    const dvec3 y(0.0, 1.0, 0.0);
    const dvec3 z(0.0, 0.0, 1.0);
    std::vector<Surface> faces;
    for (const auto& [right, up] : {std::pair(x, y), {-x, y}, {-z, y}, {z, y}, {x, -z}, {x, z}})
        faces.push_back(boxFace(right, up, halfSize, radius, stepsPerCorner));
    return faces;
}

} // namespace torrance::assets
