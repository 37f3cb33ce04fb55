// Surface parameters as glTF 2.0 names them. Every colour is linear; every texture value is multiplied by its factor.
#pragma once

#include "math/vector.h"

#include <string>

namespace torrance {

/// A use of a texture by a material. uv' = transform * (u, v, 1), KHR_texture_transform; u right, v down, origin
/// top-left.
struct TextureUse
{
    int texture = -1;                                                    // Scene::textures, -1 = none
    int uvSet = 0;                                                       // 0 or 1
    glm::dmat3x2 transform = glm::dmat3x2(1.0, 0.0, 0.0, 1.0, 0.0, 0.0); // columns: d/du, d/dv, offset

    bool used() const { return texture >= 0; }
    bool operator==(const TextureUse&) const = default;
};

enum class AlphaMode
{
    opaque,
    mask,
    blend,
};

struct Material
{
    std::string name;

    dvec4 baseColorFactor = dvec4(1.0);
    TextureUse baseColor; // sRGB colour, linear alpha

    double metallicFactor = 1.0;
    double roughnessFactor = 1.0; // perceptual roughness
    TextureUse metallicRoughness; // G = roughness, B = metallic

    double normalScale = 1.0;
    TextureUse normal; // tangent space, +Y up

    double occlusionStrength = 1.0;
    TextureUse occlusion; // R

    dvec3 emissiveFactor = dvec3(0.0); // times KHR_materials_emissive_strength
    TextureUse emissive;               // sRGB

    AlphaMode alphaMode = AlphaMode::opaque;
    double alphaCutoff = 0.5;
    bool doubleSided = false;
    bool unlit = false; // KHR_materials_unlit: base colour only

    double ior = 1.5; // of the dielectric part: glTF's where nothing else is said

    bool operator==(const Material&) const = default;
};

} // namespace torrance
