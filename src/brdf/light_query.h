// What the formulas of environments, of area lights, of textures and of specular antialiasing are given, in double.
#pragma once

#include "brdf/shading_point.h"

#include <functional>
#include <span>

namespace torrance::brdf {

struct Preset;

/// What shines from a direction of an environment's lamps, and how densely their points lie there.
struct LampLight
{
    dvec3 radiance = dvec3(0.0);
    double density = 0.0; // 1/sr, of the points of its kind; 0 where no point stands for it
};

/// A point that stands for a part of an environment's lamps.
struct LampPoint
{
    dvec3 direction = dvec3(0, 1, 0); // unit
    dvec3 energy = dvec3(0.0);        // radiance times solid angle
    double density = 0.0;             // 1/sr, of all points of its kind
};

/// Light from all directions on a surface point. Directions are unit and point away from the surface.
struct EnvironmentQuery
{
    std::function<dvec3(const dvec3& direction)> radiance;
    dvec3 n = dvec3(0, 0, 1), v = dvec3(0, 0, 1);
    double perceptualRoughness = 1;
    dvec3 f0 = dvec3(0.04);           // of the specular lobe, Schlick's with f90 = 1
    int samples = 0;                  // of the methods that draw samples
    dvec2 rotation = dvec2(0.0, 0.0); // in [0, 1): moves their points, modulo 1
    // Of the method vndf_lamps: a part of `radiance`, and the points that stand for it. None: all is the rest.
    std::span<const LampPoint> lampPoints = {};
    std::function<LampLight(const dvec3& direction)> lamps = {};
};

/// A sphere of even radiance intensity / (pi radius^2), shining outwards: from far off it is a point light of this
/// intensity. A point on or inside the sphere sees it over the whole hemisphere about the direction of the centre.
struct AreaQuery
{
    const Preset& methods;
    ShadingPoint surface = {};       // n, v, roughness and material; what depends on l is not read
    dvec3 toCenter = dvec3(0, 0, 1); // metres, from the surface point
    double radius = 0;               // metres
    dvec3 intensity = dvec3(1);      // candela, with the cone and the range of the light in it
    int samples = 0;                 // of the method `sampled`
    dvec2 rotation = dvec2(0.0, 0.0);
};

/// How a texture moves under a quad of pixels, in its texels: from the first pixel to that on its right, and to that
/// below.
struct TexelFootprint
{
    dvec2 right = dvec2(0), below = dvec2(0);
};

/// The normals that a pixel covers.
struct NormalFootprint
{
    dvec3 dndx = dvec3(0), dndy = dvec3(0); // of the unit shading normal, per pixel to the right and downwards
    double meanLength = 1;                  // of the mean of the normal map's unit normals under the pixel
    double alpha = 1;                       // of the surface at one point
};

} // namespace torrance::brdf
