#include "reference/emission.h"

namespace torrance {

dvec3 emittedRadiance(const Scene& scene, const SurfacePoint& surface, const MaterialPoint& material)
{
    if (!surface.front && !materialOf(scene, surface.material).doubleSided)
        return dvec3(0.0);
    return material.unlit ? material.baseColor : material.emissive;
}

} // namespace torrance
