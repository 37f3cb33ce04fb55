// Lat-long panoramas from a function of direction.
#pragma once

#include "image/image.h"
#include "math/vector.h"

#include <functional>

namespace torrance::assets {

/// The unit direction of a place in a panorama: u = 0.5 + atan2(z, x) / 2 pi, v = acos(y) / pi, top row +Y.
dvec3 panoramaDirection(double u, double v);

/// A panorama of `radiance`, each texel the mean of grid x grid directions inside it.
Image panorama(int width, int height, int grid, const std::function<dvec3(const dvec3&)>& radiance);

/// Solid angle of each texel of row y, in steradians.
double texelSolidAngle(int width, int height, int y);

/// The irradiance over pi on a surface with this normal: what a white diffuse surface there would show.
dvec3 whiteRadiance(const Image& panorama, const dvec3& normal);

} // namespace torrance::assets
