// Where two materials differ.
#pragma once

#include "scene/material.h"

#include <array>
#include <string>

namespace torrance {

/// The five uses of textures, under glTF's names.
struct NamedTextureUse
{
    const char* name; // "baseColorTexture"
    TextureUse Material::*use;
};
inline constexpr std::array<NamedTextureUse, 5> kTextureUses = {{
    {"baseColorTexture", &Material::baseColor},
    {"metallicRoughnessTexture", &Material::metallicRoughness},
    {"normalTexture", &Material::normal},
    {"occlusionTexture", &Material::occlusion},
    {"emissiveTexture", &Material::emissive},
}};

/// The first field in which a material differs from another, "roughnessFactor", or "" where they are the same: bit by
/// bit, but for transforms of texture coordinates, which may differ by kUvTransformError, and for what does nothing:
/// the scale of a normal map, the strength of an occlusion map and the uses themselves where there is no such map.
std::string differingField(const Material& a, const Material& b);

} // namespace torrance
