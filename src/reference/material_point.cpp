#include "reference/material_point.h"

#include "reference/texture_sampling.h"

#include <algorithm>

namespace torrance {
namespace {

dvec4 baseColorAt(const Scene& scene, const Material& material, const SurfacePoint& surface)
{
    return material.baseColorFactor * surface.color *
           sampleUse(scene, material.baseColor, surface.uvs, ColorSpace::srgb);
}

double coverageOf(const Material& material, double alpha)
{
    switch (material.alphaMode) {
    case AlphaMode::opaque:
        return 1.0;
    case AlphaMode::mask:
        return alpha >= material.alphaCutoff ? 1.0 : 0.0;
    case AlphaMode::blend:
        break;
    }
    return std::clamp(alpha, 0.0, 1.0);
}

/// glTF 2.0 section 3.9.3: the texel's x and y are scaled, then the vector is normalised.
dvec3 mappedNormal(const Scene& scene, const Material& material, const SurfacePoint& surface)
{
    if (!material.normal.used() || !surface.frame)
        return surface.normal;
    const dvec4 texel = sampleUse(scene, material.normal, surface.uvs, ColorSpace::linear);
    const dvec3 local = (2.0 * dvec3(texel) - 1.0) * dvec3(material.normalScale, material.normalScale, 1.0);
    const TangentFrame& frame = *surface.frame;
    const dvec3 bent = local.x * frame.tangent + local.y * frame.bitangent + local.z * surface.normal;
    const double length = glm::length(bent);
    return length > 0.0 ? bent / length : surface.normal;
}

dvec3 bendNormal(const dvec3& normal, const dvec3& view)
{
    const double NoV = glm::dot(normal, view);
    return NoV < kMinNoV ? glm::normalize(normal + (kMinNoV - NoV) * view) : normal;
}

} // namespace

double coverageAt(const Scene& scene, const SurfacePoint& surface)
{
    const Material& material = materialOf(scene, surface.material);
    return coverageOf(material, baseColorAt(scene, material, surface).a);
}

MaterialPoint makeMaterialPoint(const Scene& scene, const SurfacePoint& surface)
{
    const Material& material = materialOf(scene, surface.material);
    const dvec4 base = baseColorAt(scene, material, surface);
    const dvec4 metalRough = sampleUse(scene, material.metallicRoughness, surface.uvs, ColorSpace::linear);
    const double occlusion = sampleUse(scene, material.occlusion, surface.uvs, ColorSpace::linear).r;
    MaterialPoint point;
    point.baseColor = dvec3(base);
    point.alpha = coverageOf(material, base.a);
    point.metallic = std::clamp(material.metallicFactor * metalRough.b, 0.0, 1.0);
    point.perceptualRoughness = std::clamp(material.roughnessFactor * metalRough.g, 0.0, 1.0);
    point.occlusion = 1.0 + material.occlusionStrength * (occlusion - 1.0);
    point.emissive =
        material.emissiveFactor * dvec3(sampleUse(scene, material.emissive, surface.uvs, ColorSpace::srgb));
    point.normal = bendNormal((surface.front ? 1.0 : -1.0) * mappedNormal(scene, material, surface), surface.view);
    point.unlit = material.unlit;
    point.ior = material.ior;
    return point;
}

} // namespace torrance
