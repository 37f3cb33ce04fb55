#include "reference/analytic_shape.h"

#include <cmath>

namespace torrance {
namespace {

std::optional<ShapeHit> intersectSphere(const dvec3& center, double radius, const Ray& ray, Sides seen)
{
    // The half chord comes from the distance of the centre from the ray, not from b^2 - c: where the sphere is small
    // and far that difference has few bits left (Haines et al., Ray Tracing Gems 2019, chapter 7).
    const dvec3 toCenter = center - ray.origin;
    const double along = glm::dot(toCenter, ray.direction);
    const dvec3 across = toCenter - along * ray.direction;
    const double halfChord2 = (radius - glm::length(across)) * (radius + glm::length(across));
    if (!(halfChord2 > 0.0))
        return std::nullopt;
    const double halfChord = std::sqrt(halfChord2);
    const bool outside = glm::dot(toCenter, toCenter) > radius * radius;
    if (outside ? along <= 0.0 : seen == Sides::front)
        return std::nullopt;
    const dvec3 fromCenter = (outside ? -halfChord : halfChord) * ray.direction - across;
    return ShapeHit{along + (outside ? -halfChord : halfChord), glm::normalize(fromCenter), center + fromCenter};
}

std::optional<ShapeHit> intersectPlane(const dvec3& center, const dmat3& axes, const Ray& ray, Sides seen)
{
    const dvec3 normal = glm::normalize(glm::cross(axes[0], axes[1]));
    const double facing = glm::dot(normal, ray.direction);
    if (facing == 0.0 || (facing > 0.0 && seen == Sides::front))
        return std::nullopt;
    const double distance = glm::dot(normal, center - ray.origin) / facing;
    const dvec3 position = ray.origin + distance * ray.direction;
    const double x = glm::dot(position - center, axes[0]) / glm::dot(axes[0], axes[0]);
    const double y = glm::dot(position - center, axes[1]) / glm::dot(axes[1], axes[1]);
    if (!(distance > 0.0) || !(std::abs(x) <= 1.0) || !(std::abs(y) <= 1.0))
        return std::nullopt;
    return ShapeHit{distance, normal, position};
}

} // namespace

std::optional<ShapeHit> intersectShape(const AnalyticShape& shape, const dvec3& origin, const Ray& ray, Sides seen)
{
    const dvec3 center = dvec3(shape.worldFromObject[3]) - origin;
    const dmat3 axes(shape.worldFromObject);
    if (shape.kind == AnalyticShape::Kind::sphere)
        return intersectSphere(center, glm::length(axes[0]), ray, seen);
    return intersectPlane(center, axes, ray, seen);
}

} // namespace torrance
