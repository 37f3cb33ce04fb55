// What a ray sees through blended surfaces, nearest first.
#pragma once

#include "reference/material_point.h"

#include <vector>

namespace torrance {

struct VisibleSurface
{
    SurfacePoint surface;
    MaterialPoint material;
    double share = 1.0; // of the pixel: the material's alpha times what the nearer surfaces let through
};

struct VisibleSurfaces
{
    std::vector<VisibleSurface> surfaces;
    double through = 1.0; // share of what lies behind all of them
};

/// Blended surfaces count in the order in which the ray meets them, as glTF 2.0, 3.9.4, has it (over), both sides of
/// double-sided ones. A renderer that sorts whole primitives differs where they cross.
/// `quad` as of makeSurfacePoint.
VisibleSurfaces visibleSurfaces(const RayCaster& caster, const Ray& ray, const QuadRays* quad = nullptr);

/// The first of them: what makes a pixel covered.
std::optional<Hit> firstVisible(const RayCaster& caster, const Ray& ray, const QuadRays* quad = nullptr);

} // namespace torrance
