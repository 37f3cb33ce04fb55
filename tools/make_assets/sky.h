// A clear day: an analytic sky and a sun of its true size and brightness.
#pragma once

#include "image/image.h"
#include "math/vector.h"

namespace torrance::assets {

inline constexpr double kSunAngularRadius = 0.2665 * kPi / 180.0; // radians, as seen from the Earth

/// The sun's radiance where the sky's zenith has about 0.3: both kept in the proportion of a clear day, 1.6e9 to 5e3
/// cd/m2.
dvec3 sunRadiance();

/// The direction to the sun in a panorama of this size. It is the middle of a texel, so that one texel is covered
/// wholly.
dvec3 sunDirection(int width, int height);

/// The sun's texels hold its energy exactly: their sum over solid angle is sunRadiance() times the disc's solid angle.
Image skyPanorama(int width, int height);

} // namespace torrance::assets
