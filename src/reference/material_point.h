// The material at a point of the surface: every texture sampled, every factor multiplied in.
#pragma once

#include "reference/surface_point.h"

namespace torrance {

/// A shading normal that interpolation or a normal map turned away from the viewer is bent, in the plane of both, until
/// n.v has this value to first order: the surface is seen. It alters points with n.v below it only. The same constant
/// stands in shaders/shared/constants.h.
inline constexpr double kMinNoV = 1e-4;

struct MaterialPoint
{
    dvec3 baseColor = dvec3(1.0);
    double alpha = 1.0; // coverage: 1 where the material is opaque; 0 or 1 where it is masked
    double metallic = 1.0;
    double perceptualRoughness = 1.0;
    double ior = 1.5;       // of the dielectric part
    double occlusion = 1.0; // share of the environment's light that arrives
    dvec3 emissive = dvec3(0.0);
    dvec3 normal = dvec3(0.0, 0.0, 1.0); // unit, normal-mapped, n.v >= kMinNoV
    bool unlit = false;
};

/// As glTF 2.0 section 3.9 defines it. A normal map bends the normal where the point has a tangent frame.
MaterialPoint makeMaterialPoint(const Scene& scene, const SurfacePoint& surface);

/// Coverage of a point alone: base colour's alpha under the material's mode.
double coverageAt(const Scene& scene, const SurfacePoint& surface);

} // namespace torrance
