// The points at which every shading term is looked at.
#pragma once

#include "brdf/shading_point.h"

#include <string>
#include <vector>

namespace torrance {

/// The direction of a cosine to +Z and an azimuth from +X.
dvec3 directionAt(double cosine, double azimuth);

/// Roughness 0.01 to 1, cosines from grazing to normal, azimuths to the mirror direction, normals along an axis and
/// tilted; and random points, a half of them with h within a few widths of the highlight. Always the same.
std::vector<brdf::ShadingPoint> probeGrid();

/// Scalars at the ends of their ranges, each by itself: no directions belong to them.
std::vector<brdf::ShadingPoint> probeCorners();

/// The scalars of a point, for the message of a failure.
std::string describe(const brdf::ShadingPoint& point);

} // namespace torrance
