// Small scenes for tests of the plan.
#pragma once

#include "plan/shading_plan.h"

#include <cstdint>
#include <cstring>

namespace torrance::test {

inline Settings settings(const char* preset = "gltf")
{
    return {.methods = *brdf::findPreset(preset), .width = 16, .height = 16};
}

/// A triangle with all attributes.
inline Primitive triangle(int material)
{
    Primitive p;
    p.name = "triangle";
    p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    p.normals.assign(3, vec3(0, 0, 1));
    p.uvs[0] = {{0, 0}, {1, 0}, {0, 1}};
    p.indices = {0, 1, 2};
    p.material = material;
    p.boundsMax = dvec3(1, 1, 0);
    return p;
}

/// One triangle, one material.
inline Scene sceneWith(const Material& material)
{
    Scene scene;
    scene.materials = {material};
    scene.primitives = {triangle(0)};
    scene.instances = {Instance{}};
    return scene;
}

/// Adds a texture of two texels to the scene and returns a use of it.
inline TextureUse addTexture(Scene& scene, std::array<std::uint8_t, 4> first, std::array<std::uint8_t, 4> second)
{
    TextureImage image = {.name = "two texels", .width = 2, .height = 1, .texels = std::vector<std::byte>(8)};
    std::memcpy(image.texels.data(), first.data(), 4);
    std::memcpy(image.texels.data() + 4, second.data(), 4);
    scene.images.push_back(std::move(image));
    scene.textures.push_back({.image = static_cast<int>(scene.images.size()) - 1});
    return {.texture = static_cast<int>(scene.textures.size()) - 1};
}

} // namespace torrance::test
