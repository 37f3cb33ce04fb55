#include "files/material_difference.h"

#include "files/uv_transform.h"

namespace torrance {
namespace {

bool near(const dvec2& a, const dvec2& b)
{
    return a == b || glm::length(a - b) <= kUvTransformError * glm::length(b);
}

std::string differingPart(const TextureUse& a, const TextureUse& b)
{
    const auto& [texture, uvSet, transform] = b; // all of them: a new member does not compile until it is compared
    if (a.texture != texture)
        return "index";
    if (!a.used())
        return "";
    if (a.uvSet != uvSet)
        return "texCoord";
    if (!near(a.transform[0], transform[0]) || !near(a.transform[1], transform[1]) || a.transform[2] != transform[2])
        return "transform (an offset, a rotation and two scales are all that glTF holds)";
    return "";
}

} // namespace

std::string differingField(const Material& a, const Material& b)
{
    // All of them: a new member does not compile until it is compared.
    const auto& [name, baseColorFactor, baseColor, metallicFactor, roughnessFactor, metallicRoughness, normalScale,
                 normal, occlusionStrength, occlusion, emissiveFactor, emissive, alphaMode, alphaCutoff, doubleSided,
                 unlit, ior] = b;
    const std::pair<const char*, bool> fields[] = {
        {"name", a.name == name},
        {"baseColorFactor", a.baseColorFactor == baseColorFactor},
        {"metallicFactor", a.metallicFactor == metallicFactor},
        {"roughnessFactor", a.roughnessFactor == roughnessFactor},
        {"normalTexture/scale", !normal.used() || a.normalScale == normalScale},
        {"occlusionTexture/strength", !occlusion.used() || a.occlusionStrength == occlusionStrength},
        {"emissiveFactor", a.emissiveFactor == emissiveFactor},
        {"alphaMode", a.alphaMode == alphaMode},
        {"alphaCutoff", a.alphaCutoff == alphaCutoff},
        {"doubleSided", a.doubleSided == doubleSided},
        {"unlit", a.unlit == unlit},
        {"ior", a.ior == ior},
    };
    for (const auto& [field, same] : fields)
        if (!same)
            return field;
    for (const auto& [field, use] : kTextureUses)
        if (const std::string part = differingPart(a.*use, b.*use); !part.empty())
            return field + std::string("/") + part;
    return "";
}

} // namespace torrance
