#include "reference/visible_surfaces.h"

namespace torrance {
namespace {

std::optional<Hit> nextVisible(const RayCaster& caster, const Ray& ray, double beyond, const QuadRays* quad)
{
    const Scene& scene = caster.scene();
    return caster.closest(ray, beyond, [&](const Hit& hit) {
        return materialOf(scene, materialIndexOf(scene, hit)).alphaMode == AlphaMode::opaque ||
               coverageAt(scene, makeSurfacePoint(caster, ray, hit, quad)) > 0.0;
    });
}

} // namespace

std::optional<Hit> firstVisible(const RayCaster& caster, const Ray& ray, const QuadRays* quad)
{
    return nextVisible(caster, ray, 0.0, quad);
}

VisibleSurfaces visibleSurfaces(const RayCaster& caster, const Ray& ray, const QuadRays* quad)
{
    VisibleSurfaces seen;
    double beyond = 0.0;
    while (seen.through > 0.0) {
        const std::optional<Hit> hit = nextVisible(caster, ray, beyond, quad);
        if (!hit)
            break;
        VisibleSurface visible;
        visible.surface = makeSurfacePoint(caster, ray, *hit, quad);
        visible.material = makeMaterialPoint(caster.scene(), visible.surface);
        visible.share = seen.through * visible.material.alpha;
        seen.through *= 1.0 - visible.material.alpha;
        seen.surfaces.push_back(visible);
        beyond = hit->distance;
    }
    return seen;
}

} // namespace torrance
