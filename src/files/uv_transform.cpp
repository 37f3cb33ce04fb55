#include "files/uv_transform.h"

#include <cmath>
#include <limits>
#include <optional>

namespace torrance {
namespace {

/// Doubles on either side of a rounded angle and scale among which the one that was written is looked for.
constexpr int kNeighbours = 4;

dvec2 firstColumn(double rotation, double scale)
{
    return scale * dvec2(std::cos(rotation), -std::sin(rotation));
}

dvec2 secondColumn(double rotation, double scale)
{
    return scale * dvec2(std::sin(rotation), std::cos(rotation));
}

double moved(double value, int steps)
{
    const double towards = std::copysign(std::numeric_limits<double>::infinity(), steps);
    for (int i = 0; i < std::abs(steps); ++i)
        value = std::nextafter(value, towards);
    return value;
}

/// 0, 1, -1, 2, -2 ...: the likeliest first.
int neighbour(int i)
{
    return i % 2 == 0 ? -i / 2 : i / 2 + 1;
}

template <typename Column>
std::optional<double> scaleThatGives(const dvec2& column, double rotation, double near, Column&& columnOf)
{
    for (int i = 0; i <= 2 * kNeighbours; ++i)
        if (const double scale = moved(near, neighbour(i)); columnOf(rotation, scale) == column)
            return scale;
    return std::nullopt;
}

/// The transform about this rotation, exact where `exact` is set.
UvTransform about(const glm::dmat3x2& matrix, double rotation, bool& exact)
{
    const dvec2 u(std::cos(rotation), -std::sin(rotation));
    const dvec2 v(std::sin(rotation), std::cos(rotation));
    const dvec2 near(glm::dot(matrix[0], u), glm::dot(matrix[1], v));
    for (int i = 0; i <= 2 * kNeighbours; ++i) {
        const double angle = moved(rotation, neighbour(i));
        const auto first = scaleThatGives(matrix[0], angle, near.x, firstColumn);
        const auto second = first ? scaleThatGives(matrix[1], angle, near.y, secondColumn) : std::nullopt;
        if (second) {
            exact = true;
            return {matrix[2], angle, dvec2(*first, *second)};
        }
    }
    return {matrix[2], rotation, near};
}

} // namespace

glm::dmat3x2 matrixOf(const UvTransform& transform)
{
    return {firstColumn(transform.rotation, transform.scale.x), secondColumn(transform.rotation, transform.scale.y),
            transform.offset};
}

UvTransform uvTransformOf(const glm::dmat3x2& matrix)
{
    const dvec2 first = matrix[0];
    const dvec2 second = matrix[1];
    if (first.y == 0.0 && second.x == 0.0)
        return {matrix[2], 0.0, dvec2(first.x, second.y)};
    const bool hasFirst = first != dvec2(0.0);
    bool exact = false;
    const UvTransform found =
        about(matrix, hasFirst ? std::atan2(-first.y, first.x) : std::atan2(second.x, second.y), exact);
    if (exact || !hasFirst)
        return found;
    // The same turned by half a circle, with both scales negated.
    const UvTransform turned = about(matrix, std::atan2(first.y, -first.x), exact);
    return exact ? turned : found;
}

} // namespace torrance
