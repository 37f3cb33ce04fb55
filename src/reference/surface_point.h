// The surface where a ray meets it: place, normals, frame, texture coordinates, colour.
#pragma once

#include "reference/ray_caster.h"
#include "reference/texture_levels.h"

#include <array>
#include <optional>

namespace torrance {

/// The axes of a normal map beside the normal: along the texture's u, and against its v.
struct TangentFrame
{
    dvec3 tangent = dvec3(1.0, 0.0, 0.0);   // unit
    dvec3 bitangent = dvec3(0.0, 1.0, 0.0); // w * cross(normal, tangent), w negated where the node mirrors
};

/// What a pixel covers around the point: by what its texture coordinates are filtered.
struct SurfaceFootprint
{
    std::array<UvSteps, 2> uvs;
    double levelBias = 0.0;
};

/// The rays through the same place of three pixels of a quad, the first, the one on its right and the one below it.
/// What changes between them a device takes for the derivatives of all four (SPIR-V's OpDPdxCoarse).
struct QuadRays
{
    Ray first, right, below;
    double levelBias = 0.0; // of the textures' levels
};

struct SurfacePoint
{
    dvec3 view = dvec3(0.0, 0.0, 1.0);  // unit, towards where the ray comes from
    dvec3 position = dvec3(0.0);        // relative to the caster's origin
    double distance = 0.0;              // along the ray
    dvec3 geometricNormal = dvec3(0.0); // unit, towards the side that is seen
    dvec3 normal = dvec3(0.0); // interpolated vertex normal, unit, of the front side (not yet turned for back faces)
    bool front = true;         // the front side is seen
    std::optional<TangentFrame> frame;
    std::array<dvec2, 2> uvs = {dvec2(0.0), dvec2(0.0)};
    std::optional<SurfaceFootprint> footprint;
    dvec4 color = dvec4(1.0); // COLOR_0
    int material = -1;
    int object = -1; // Instance::object; of analytic shape number i, -1 - i
};

/// Normals go through the cofactor matrix times the determinant's sign, tangents through the matrix; both are
/// interpolated before they are made unit. Where a primitive has no normals, or they vanish, the triangle's own stands
/// in. With a quad the point has a footprint: where its rays meet the plane of its triangle, wherever that ends.
SurfacePoint makeSurfacePoint(const RayCaster& caster, const Ray& ray, const Hit& hit, const QuadRays* quad = nullptr);

} // namespace torrance
