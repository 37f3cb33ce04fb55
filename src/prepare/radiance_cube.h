// A lat-long panorama on the faces of a cube, its energy kept.
#pragma once

#include "image/image.h"
#include "prepare/cube_tree.h"

#include <vector>

namespace torrance {

/// A panorama in two parts, told apart because a mean is safe for one and not for the other: what lies below a few
/// times the panorama's robust mean, resampled; and the excess of suns and lamps above it, deposited with its exact
/// energy.
struct RadianceCube
{
    int size = 0;
    CubeLeaves base;             // of all texels: direction of its centre, energy = radiance * solid angle
    CubeLeaves excess;           // of some: energy-weighted direction of what was deposited
    std::vector<float> radiance; // base + excess as 6 * size^2 RGBA texels
};

/// `size` is a power of two, at least 2.
RadianceCube makeRadianceCube(const Image& panorama, int size);

} // namespace torrance
