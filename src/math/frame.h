// Axes about a normal.
#pragma once

#include "math/vector.h"

#include <cmath>

namespace torrance {

/// A right-handed orthonormal frame whose third column is the unit vector n: Duff et al., Building an Orthonormal
/// Basis, Revisited, 2017, listing 3. Columns take local directions to those of n's space.
inline dmat3 frameAround(const dvec3& n)
{
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    return {dvec3(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x), dvec3(b, sign + n.y * n.y * a, -n.y), n};
}

} // namespace torrance
