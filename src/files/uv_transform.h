// KHR_texture_transform: an offset, a rotation and two scales as a matrix, and back.
#pragma once

#include "math/vector.h"

namespace torrance {

struct UvTransform
{
    dvec2 offset = dvec2(0.0);
    double rotation = 0.0; // radians, counter-clockwise as one sees them with v pointing down
    dvec2 scale = dvec2(1.0);
};

/// Offset * rotation * scale.
glm::dmat3x2 matrixOf(const UvTransform& transform);

/// What matrixOf makes `matrix` from: exactly, bit by bit, where the matrix came from it with a rotation and scales of
/// ordinary size, else within kUvTransformError. Of a matrix that shears, which no transform gives, the nearest by its
/// first column.
UvTransform uvTransformOf(const glm::dmat3x2& matrix);

/// By how much a column may differ, relative to its length, when no doubles give it exactly: roundings of the scale
/// (1/2 ulp), of the sine or cosine (1) and of their product (1/2), and the angle's own (up to 2.2e-16 at pi), which
/// moves a column by as much. All in all under 2.5 epsilons; rounded up.
inline constexpr double kUvTransformError = 4.0 * 2.220446049250313e-16;

} // namespace torrance
