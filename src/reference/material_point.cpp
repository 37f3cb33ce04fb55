#include "reference/material_point.h"

#include "reference/texture_levels.h"

#include <algorithm>

namespace torrance {
namespace {

/// A use of a texture at a point: by level where the point has a footprint, at level 0 where it has none.
dvec4 sampleAt(const Scene& scene, const TextureUse& use, const SurfacePoint& surface, const LevelRule& rule)
{
    const ColorSpace space = rule.content == TexelContent::color ? ColorSpace::srgb : ColorSpace::linear;
    if (!use.used() || !surface.footprint)
        return sampleUse(scene, use, surface.uvs, space);
    const Texture& texture = scene.textures[static_cast<std::size_t>(use.texture)];
    const TextureImage& image = scene.images[static_cast<std::size_t>(texture.image)];
    const glm::dmat2 turn(use.transform[0], use.transform[1]);
    const UvSteps& steps = surface.footprint->uvs[static_cast<std::size_t>(use.uvSet)];
    const double bias = texture.sampler.mip == MipFilter::none ? 0.0 : surface.footprint->levelBias;
    return sampleLevels(image, texture.sampler, rule, usedUv(use, surface.uvs),
                        levelOfDetail(image, {turn * steps.right, turn * steps.below}, bias));
}

dvec4 baseColorAt(const Scene& scene, const Material& material, const SurfacePoint& surface)
{
    return material.baseColorFactor * surface.color *
           sampleAt(scene, material.baseColor, surface,
                    {.content = TexelContent::color, .weighByAlpha = material.alphaMode != AlphaMode::opaque});
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
    const dvec4 texel = sampleAt(scene, material.normal, surface, {TexelContent::normal});
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
    const dvec4 metalRough = sampleAt(scene, material.metallicRoughness, surface, {TexelContent::data});
    const double occlusion = sampleAt(scene, material.occlusion, surface, {TexelContent::data}).r;
    MaterialPoint point;
    point.baseColor = dvec3(base);
    point.alpha = coverageOf(material, base.a);
    point.metallic = std::clamp(material.metallicFactor * metalRough.b, 0.0, 1.0);
    point.perceptualRoughness = std::clamp(material.roughnessFactor * metalRough.g, 0.0, 1.0);
    point.occlusion = 1.0 + material.occlusionStrength * (occlusion - 1.0);
    point.emissive =
        material.emissiveFactor * dvec3(sampleAt(scene, material.emissive, surface, {TexelContent::color}));
    point.normal = bendNormal((surface.front ? 1.0 : -1.0) * mappedNormal(scene, material, surface), surface.view);
    point.unlit = material.unlit;
    point.ior = material.ior;
    return point;
}

} // namespace torrance
