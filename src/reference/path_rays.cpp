#include "reference/path_rays.h"

#include <algorithm>

namespace torrance {

PathRays::PathRays(const RayCaster& rays) : caster(rays)
{
    const Scene& scene = caster.scene();
    if (std::ranges::any_of(scene.materials, [](const Material& m) { return m.alphaMode != AlphaMode::opaque; }))
        isThere = [this](const Hit& hit) {
            const Scene& s = caster.scene();
            return materialOf(s, materialIndexOf(s, hit)).alphaMode == AlphaMode::opaque ||
                   coverageAt(s, makeSurfacePoint(caster, Ray(), hit)) > 0.0;
        };
}

double PathRays::transmittance(const dvec3& from, const dvec3& direction, double farthest) const
{
    const Ray ray = {from, direction};
    if (!isThere)
        return caster.blocked(ray, farthest) ? 0.0 : 1.0;
    double through = 1.0;
    for (double beyond = 0.0; through > 0.0;) {
        const std::optional<Hit> hit = caster.closest(ray, beyond, isThere, Faces::both);
        if (!hit || !(hit->distance < farthest))
            break;
        through *= 1.0 - coverageAt(caster.scene(), makeSurfacePoint(caster, ray, *hit));
        beyond = hit->distance;
    }
    return through;
}

std::optional<PathSurface> PathRays::next(const Ray& ray, NumberStream& numbers) const
{
    for (double beyond = 0.0;;) {
        const std::optional<Hit> hit = caster.closest(ray, beyond, isThere, Faces::both);
        if (!hit)
            return std::nullopt;
        PathSurface met = {*hit, makeSurfacePoint(caster, ray, *hit), {}};
        met.material = makeMaterialPoint(caster.scene(), met.surface);
        if (met.material.alpha >= 1.0 || numbers.next() < met.material.alpha)
            return met;
        beyond = hit->distance;
    }
}

} // namespace torrance
