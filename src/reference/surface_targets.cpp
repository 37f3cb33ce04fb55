#include "reference/surface_targets.h"

#include "core/parallel.h"
#include "reference/material_point.h"
#include "scene/camera_view.h"

#include <array>

namespace torrance {
namespace {

constexpr std::size_t kTargets = 6;

// Masked surfaces have holes; blended ones are there whatever their alpha.
bool isThere(const RayCaster& caster, const Ray& ray, const Hit& hit)
{
    const Scene& scene = caster.scene();
    return materialOf(scene, materialIndexOf(scene, hit)).alphaMode != AlphaMode::mask ||
           coverageAt(scene, makeSurfacePoint(caster, ray, hit)) > 0.0;
}

std::array<dvec4, kTargets> valuesAt(const Scene& scene, const SurfacePoint& surface, const dvec3& forward)
{
    const MaterialPoint m = makeMaterialPoint(scene, surface);
    const int object = surface.object < 0 ? -1 - surface.object : surface.object; // shapes count by themselves
    const int material = surface.material < 0 ? static_cast<int>(scene.materials.size()) : surface.material;
    return {dvec4(surface.position, glm::dot(surface.position, forward)),
            dvec4(m.normal, m.perceptualRoughness),
            dvec4(surface.geometricNormal, m.metallic),
            dvec4(m.baseColor, m.occlusion),
            dvec4(m.emissive, 1.0),
            dvec4(object + 1.0, material + 1.0, 0.0, 0.0)};
}

} // namespace

std::vector<Image> surfaceTargets(const Scene& scene, const Camera& camera, int width, int height)
{
    const RayCaster caster(scene, cameraPosition(camera));
    const dmat4 view = viewFromWorld(camera);
    const dvec3 forward = -dvec3(view[0].z, view[1].z, view[2].z);
    std::vector<Image> targets(kTargets, Image(width, height, 4));
    parallelFor(static_cast<std::size_t>(height), 1, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x) {
            const Ray ray = primaryRay(camera, width, height, x + 0.5, y + 0.5);
            const auto hit = caster.closest(ray, 0.0, [&](const Hit& h) { return isThere(caster, ray, h); });
            if (!hit)
                continue;
            const auto values = valuesAt(scene, makeSurfacePoint(caster, ray, *hit), forward);
            for (std::size_t t = 0; t < kTargets; ++t)
                for (int c = 0; c < 4; ++c)
                    targets[t].at(x, y)[c] = static_cast<float>(values[t][c]);
        }
    });
    return targets;
}

} // namespace torrance
