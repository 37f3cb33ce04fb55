#include "reference/visible_surfaces.h"

namespace torrance {

VisibleSurfaces visibleSurfaces(const RayCaster& caster, const Ray& ray)
{
    const Scene& scene = caster.scene();
    const auto accept = [&](const Hit& hit) {
        return materialOf(scene, materialIndexOf(scene, hit)).alphaMode == AlphaMode::opaque ||
               coverageAt(scene, makeSurfacePoint(caster, ray, hit)) > 0.0;
    };
    VisibleSurfaces seen;
    double beyond = 0.0;
    while (seen.through > 0.0) {
        const std::optional<Hit> hit = caster.closest(ray, beyond, accept);
        if (!hit)
            break;
        VisibleSurface visible;
        visible.surface = makeSurfacePoint(caster, ray, *hit);
        visible.material = makeMaterialPoint(scene, visible.surface);
        visible.share = seen.through * visible.material.alpha;
        seen.through *= 1.0 - visible.material.alpha;
        seen.surfaces.push_back(visible);
        beyond = hit->distance;
    }
    return seen;
}

} // namespace torrance
