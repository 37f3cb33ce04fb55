// Directions in which a path goes on from a surface point.
#pragma once

#include "reference/material_point.h"

namespace torrance {

/// A lobe and a cosine are both drawn from with at least this probability, because what estimates their shares knows
/// neither the methods nor that a lobe that is dim on average is bright somewhere. Any value above 0 is unbiased.
inline constexpr double kLeastShare = 0.1;

/// Bounded visible normals of the specular lobe (Eto & Tokuyoshi 2023) with about the share that the lobe has of the
/// reflected light, else the cosine: one sample of a mixture (Veach & Guibas 1995, section 4, the one-sample model).
/// Frame: the normal is +Z.
class BounceDirections
{
public:
    /// `view` is local, above the surface.
    BounceDirections(const MaterialPoint& material, const dvec3& view);

    /// Some directions lie below the surface, and carry nothing.
    dvec3 draw(const dvec2& u) const;
    /// Of a direction above the surface, 1/sr.
    double density(const dvec3& l) const;

private:
    dvec3 view;
    dvec2 alpha;
    double lobeShare;
};

} // namespace torrance
