// Real spherical harmonics up to band 2 and the convolution that turns radiance into irradiance.
#pragma once

#include "math/vector.h"

#include <array>

namespace torrance {

inline constexpr int kSh9Count = 9;
using Sh9 = std::array<double, kSh9Count>;

/// Y_lm(d) of a unit vector in the order (l, m) = 00, 1-1, 10, 11, 2-2, 2-1, 20, 21, 22, the polar axis along z, no
/// Condon-Shortley sign: Ramamoorthi & Hanrahan 2001, eq. 3. Orthonormal over the sphere.
Sh9 shBasis(const dvec3& d);

/// Factor of band l >= 0 when a function on the sphere is convolved with max(0, cos): Ramamoorthi & Hanrahan 2001, eq.
/// 7 to 9. pi, 2 pi / 3, pi / 4, 0, -pi / 24, ...
double clampedCosineBand(int l);

} // namespace torrance
