// What the sphere set's pixels should be, in double.
#pragma once

#include "image/image.h"
#include "study/sphere_set.h"

#include <functional>
#include <string>

namespace torrance {

struct SphereTruth
{
    Image color;    // RGB, scene-linear; 0 where no pixel counts
    Image variance; // of the mean, RGB; empty where the truth is exact
};

/// Called at every row by any thread; what it throws ends the work.
using Checkpoint = std::function<void()>;

/// Of a material, the methods that stand for it.
using MethodsOf = std::function<const brdf::Preset&(std::size_t material)>;

/// Light of directional lights by the double formulas. The Fresnel terms of an index of refraction are served too: a
/// dielectric has its material's, a metal is a conductor of index 1 + i k with its colour as normal reflectance
/// (reference/physical_surface.h).
SphereTruth lampTruth(const MethodGrid& grid, const Scene& scene, const MethodsOf& methods,
                      const Checkpoint& checkpoint = {});

/// The same for light that is reflected once, by `once`, and what random walks between facets add for twice and more
/// (brdf/random_walk.h; their facets have exact Fresnel terms of the same normal reflectance).
SphereTruth walkTruth(const MethodGrid& grid, const Scene& scene, const brdf::Preset& once,
                      const Checkpoint& checkpoint = {});

/// Light from all around of radiance 1, in closed form (reference/shade.h).
SphereTruth uniformTruth(const MethodGrid& grid, const Scene& scene, const MethodsOf& methods,
                         const Checkpoint& checkpoint = {});

/// Of which spheres an integral is asked for; the others stay black.
enum class SpheresWithLight
{
    all,
    dielectrics, // those with a body
};

/// All light of the scene by the reference's integral.
SphereTruth integralTruth(const MethodGrid& grid, const Scene& scene, const brdf::Preset& methods,
                          SpheresWithLight which = SpheresWithLight::all, const Checkpoint& checkpoint = {});

/// a - b, of one integral's numbers: what cancels in the pictures cancels in their noise, so that the variance of the
/// difference is at most (sd a + sd b)^2.
SphereTruth difference(const SphereTruth& a, const SphereTruth& b);

} // namespace torrance
