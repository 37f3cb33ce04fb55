// An environment in two parts: what varies gently, and its lamps (suns, windows), as a few points that stand for them.
#pragma once

#include "brdf/light_query.h"
#include "prepare/cube_levels.h"

#include <vector>

namespace torrance {

/// Lamps are of two kinds, by how densely points lie on them (1/sr): suns and bulbs, and windows. All points of a kind
/// count by its one density: a weight made of it is then linear in the light of each kind, and stays what it is where
/// texels of both are averaged. Of densities that vary from region to region it did not: weights are convex in them,
/// and the share that directions took was too small by up to 3 % of all light.
struct LampDensities
{
    double wide = 0.0;
    double small = 0.0; // as `wide` where all lamps are of one kind
};

struct EnvironmentLamps
{
    CubeLevels rest;  // radiance without the lamps, RGB and 1
    CubeLevels lamps; // radiance of the lamps, RGB, and in A what of the mean of the three is of small ones
    /// One a region, in the environment's axes: towards the mean of its directions, by their light; its density is that
    /// of its kind.
    std::vector<brdf::LampPoint> points;
    LampDensities densities;
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
