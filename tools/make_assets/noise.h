// Random patterns that are the same on every machine, and that repeat, so that textures tile.
#pragma once

#include "math/vector.h"

#include <cstdint>

namespace torrance::assets {

/// A value in [0, 1) that depends on the three numbers only.
double randomValue(int x, int y, std::uint32_t seed);

/// Smooth noise in [0, 1] on a lattice of unit cells that repeats after periodX and periodY cells.
double smoothNoise(double x, double y, int periodX, int periodY, std::uint32_t seed);

/// Four octaves of smoothNoise, in [0, 1].
double cloudNoise(double x, double y, int periodX, int periodY, std::uint32_t seed);

/// Worley 1996: one point somewhere in each unit cell.
struct NearestPoints
{
    double first; // distance to the nearest
    double edge;  // distance to the border with the next nearest's region
    int cellX;    // the cell that holds the nearest, in [0, period)
    int cellY;
};
NearestPoints nearestPoints(double x, double y, int period, std::uint32_t seed);

} // namespace torrance::assets
