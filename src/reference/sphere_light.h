// A light with a radius, as a surface point sees it.
#pragma once

#include "reference/directed_light.h"
#include "scene/scene.h"

namespace torrance {

/// A sphere of even radiance intensity / (pi radius^2), times what the light's range and cone leave at its centre. It
/// fills the cone of half angle asin(radius / distance); from its surface and from inside, the hemisphere about the
/// direction of its centre. Directions are drawn evenly from the cone.
class SphereLight
{
public:
    /// `origin` is what `position` is relative to. For a point or spot light with a radius; a point at its very centre,
    /// from where it has no direction, gets nothing from it.
    SphereLight(const Light& light, const dvec3& origin, const dvec3& position);

    /// `direction` is unit, in the world.
    DirectedLight at(const dvec3& direction) const;
    dvec3 draw(const dvec2& u) const;

private:
    dmat3 worldFromCone = dmat3(1.0); // +Z towards the centre
    double oneLessCosine = 1.0;       // of the half angle
    dvec3 radiance = dvec3(0.0);
};

} // namespace torrance
