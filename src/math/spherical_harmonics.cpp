#include "math/spherical_harmonics.h"

#include <cassert>
#include <cmath>

namespace torrance {

Sh9 shBasis(const dvec3& d)
{
    // Normalisation: the integrals over the sphere of x^2, x^2 y^2, (x^2 - y^2)^2 and (3 z^2 - 1)^2 are 4 pi times 1/3,
    // 1/15, 4/15, 4/5.
    static const double k0 = std::sqrt(1.0 / (4.0 * kPi));
    static const double k1 = std::sqrt(3.0 / (4.0 * kPi));
    static const double k2 = std::sqrt(15.0 / (4.0 * kPi));
    static const double k20 = std::sqrt(5.0 / (16.0 * kPi));
    static const double k22 = std::sqrt(15.0 / (16.0 * kPi));
    return {k0,
            k1 * d.y,
            k1 * d.z,
            k1 * d.x,
            k2 * d.x * d.y,
            k2 * d.y * d.z,
            k20 * (3.0 * d.z * d.z - 1.0),
            k2 * d.x * d.z,
            k22 * (d.x * d.x - d.y * d.y)};
}

double clampedCosineBand(int l)
{
    assert(l >= 0);
    if (l == 1)
        return 2.0 * kPi / 3.0;
    if (l % 2 == 1)
        return 0.0;
    double ratio = 1.0; // l! / (2^l (l/2)!^2) = product over k = 1 .. l/2 of (2k - 1) / (2k)
    for (int k = 1; k <= l / 2; ++k)
        ratio *= (2.0 * k - 1.0) / (2.0 * k);
    const double sign = (l / 2) % 2 == 1 ? 1.0 : -1.0;
    return 2.0 * kPi * sign * ratio / ((l + 2.0) * (l - 1.0));
}

} // namespace torrance
