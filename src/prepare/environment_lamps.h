// An environment in two parts: what varies gently, and its lamps (suns, windows), as a few points that stand for them.
#pragma once

#include "brdf/light_query.h"
#include "prepare/cube_levels.h"

#include <vector>

namespace torrance {

struct EnvironmentLamps
{
    CubeLevels rest; // radiance without the lamps, RGB and 1
    /// Radiance of the lamps, RGB, and in A the mean of the three times the density of the region: A over that mean is
    /// then the density of what shines, however many texels are averaged.
    CubeLevels lamps;
    /// One a region, in the environment's axes: towards the mean of its directions, by their light; its density is its
    /// share of all lamps' light, spread over it evenly.
    std::vector<brdf::LampPoint> points;
};

/// Texels brighter (mean of the channels) than this many robust means are lamps: what lies below varies so little that
/// a lobe's samples sum it well.
inline constexpr double kLampFactor = 4.0;

/// `radiance` is 6 faces of `size` (a power of two) RGBA texels. Lamps are cut into `count` regions, rectangles of
/// faces, after Agarwal et al., Structured Importance Sampling of Environment Maps, 2003: always that region whose
/// light is hardest to stand for by a point, judged by the second moment of its radiance and by its extent, at the best
/// of 16 places. Where there are fewer texels or no lamps, the last points are black. A pure function of its arguments.
EnvironmentLamps splitLamps(const std::vector<float>& radiance, int size, int count);

} // namespace torrance
