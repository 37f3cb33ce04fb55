// What the device needs of an environment: a cube prefiltered by roughness, and one of its irradiance.
#pragma once

#include "image/image.h"
#include "prepare/cube_levels.h"

namespace torrance {

inline constexpr int kLeastCubeSize = 16;
inline constexpr int kGreatestCubeSize = 512;
inline constexpr int kLastLevelSize = 8; // faces of the roughest level
inline constexpr int kIrradianceSize = 32;
/// Faces of level 0 of a source: of source E's 8 levels, each half the one before, the last then has kBlockSide texels
/// a side.
inline constexpr int kSourceCubeSize = 512;

struct EnvironmentMaps
{
    /// Level 0 is the radiance itself; level i the mean of the radiance around each direction under the split-sum
    /// kernel D(alpha_i, h) NoL of N = V = R (Karis 2013), alpha_i = levelAlpha(i, levels). Alpha channel 1.
    CubeLevels specular;
    /// One level: irradiance / pi, the mean of the radiance weighted by the clamped cosine. Alpha channel 1.
    CubeLevels irradiance;
};

/// Roughness alpha of a level: (101^(level / last) - 1) / 100. The inverse is lod = last * log2(1 + 100 alpha) /
/// log2(101): levels lie densest where reflections change fastest.
double levelAlpha(int level, int levels);

/// That inverse: between 0 and levels - 1, for alpha from 0 to 1.
double alphaLevel(double alpha, int levels);

/// Faces of the radiance cube of a panorama of this width: the power of two at or above width / 4, within the limits
/// above.
int cubeSizeFor(int panoramaWidth);

/// Directions a pixel from which on a cube that they are drawn from is worth its finer texels.
inline constexpr int kManyDirections = 256;

/// Faces of the cube from which `directions` a pixel are drawn: that of cubeSizeFor(), or, of many, twice that within
/// the limits. Texels that are interpolated twice, once for the cube and once from it, blur what a mirror shows: half
/// as large, they take half of the error, for a second or two of making them (DECISIONS.md).
int drawnCubeSize(int panoramaWidth, int directions);

/// Both from a lat-long panorama (math/latlong.h) of 3 channels, at least 1 x 1, finite and not negative
/// (asserted), of any dynamic range. A constant panorama stays constant to 1e-6; the energy of every level is the
/// panorama's within 0.5 %. The result depends on the panorama alone.
EnvironmentMaps makeEnvironmentMaps(const Image& panorama);

/// The same of the levels of source E: level i of 8 holds brdf::phongLevelExponent(i), and level 0 has kSourceCubeSize
/// texels a side whatever the panorama.
EnvironmentMaps makePhongMaps(const Image& panorama);

/// The same of the levels of source B: level i of 6 holds brdf::ggxLevelAlpha(i).
EnvironmentMaps makeGgxLevelMaps(const Image& panorama);

} // namespace torrance
