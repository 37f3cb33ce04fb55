// The yardstick `physics`: what a glTF material would reflect if its parameters were a real surface's, as far as rough
// surfaces of metals and coloured bodies under a clear interface go.
#pragma once

#include "brdf/random_walk.h"
#include "reference/material_point.h"

#include <vector>

namespace torrance {

/// Directional albedo of the dielectric interface, all orders of reflection: from random walks at the nodes of a table
/// and bilinear between them. It shares light out between interface and body; what the interface reflects is not read
/// from it.
class InterfaceAlbedo
{
public:
    /// Takes about a second of one core.
    explicit InterfaceAlbedo(double ior);

    double at(double NoV, double perceptualRoughness) const;
    /// The mean over the hemisphere, weighted by the cosine.
    double average(double perceptualRoughness) const;
    double ior() const { return index; }

private:
    double node(int cosine, int roughness) const;

    double index;
    std::vector<double> nodes;
    std::vector<double> averages; // per roughness
};

/// A metal is a conductor of index 1 + i k with the base colour as its normal reflectance, k = 2 sqrt(r / (1 - r))
/// (Pharr, Jakob & Humphreys, Physically Based Rendering, 4th edition, ConductorMaterial), with exact Fresnel terms and
/// random walks between facets of GGX and Smith. A dielectric is an interface of its material's index, the same way,
/// over a body of energy-preserving Oren-Nayar of the base colour whose roughness is the perceptual roughness. The body
/// gets what the interface leaves on the way in and on the way out, (1 - E(v)) (1 - E(l)) / (1 - mean E): reciprocal,
/// and a white Lambertian body loses nothing (Kelemen & Szirmay-Kalos 2001). Metalness mixes both.
struct PhysicalSurface
{
    PhysicalSurface(const InterfaceAlbedo& albedo, const MaterialPoint& material);

    /// An unbiased estimate of f(v, l) NoL. The normal is +Z; v is above the surface.
    dvec3 response(const dvec3& v, const dvec3& l, NumberStream& numbers) const;

    const InterfaceAlbedo& albedo;
    dvec3 baseColor;
    double metallic;
    double perceptualRoughness;
    brdf::FacetInterface facets;
};

/// What a normal reflectance of 1 counts as: k would be infinite. It alters white metals by 1e-6.
inline constexpr double kMostReflectance = 1.0 - 1e-6;

} // namespace torrance
