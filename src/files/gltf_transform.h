// Transforms as glTF composes them.
#pragma once

#include "math/vector.h"

namespace torrance {

/// translation * rotation * scale; the quaternion (x, y, z, w) is of unit length.
inline dmat4 composeTransform(const dvec3& translation, const dvec4& q, const dvec3& scale)
{
    const dvec3 x(1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.z * q.w), 2 * (q.x * q.z - q.y * q.w));
    const dvec3 y(2 * (q.x * q.y - q.z * q.w), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.x * q.w));
    const dvec3 z(2 * (q.x * q.z + q.y * q.w), 2 * (q.y * q.z - q.x * q.w), 1 - 2 * (q.x * q.x + q.y * q.y));
    return dmat4(dvec4(x * scale.x, 0), dvec4(y * scale.y, 0), dvec4(z * scale.z, 0), dvec4(translation, 1));
}

/// What normals are multiplied by: the inverse transpose up to a positive factor, without dividing by a determinant
/// that may be zero. Cofactors are det * inverse transpose, so that a mirror's negative sign is taken back.
inline dmat3 normalTransform(const dmat3& m)
{
    const dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return glm::dot(m[0], cofactors[0]) < 0.0 ? -cofactors : cofactors;
}

} // namespace torrance
