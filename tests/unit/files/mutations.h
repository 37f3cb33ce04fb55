// For files that are damaged in bulk: the dice, and what must hold of every scene that comes out all the same.
#pragma once

#include "scene/scene.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::test {

/// SplitMix64 (Steele, Lea & Flood, Fast Splittable Pseudorandom Number Generators, 2014): the same numbers everywhere.
class Random
{
public:
    explicit Random(std::uint64_t seed) : state(seed) {}

    std::uint64_t next()
    {
        std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

private:
    std::uint64_t state;
};

/// What a renderer takes for granted about a scene.
inline void expectSound(const Scene& scene)
{
    const auto below = [](int index, std::size_t count) {
        return index >= 0 && static_cast<std::size_t>(index) < count;
    };
    for (const Primitive& primitive : scene.primitives) {
        const std::size_t vertices = primitive.positions.size();
        ASSERT_FALSE(primitive.indices.empty());
        for (const std::uint32_t index : primitive.indices)
            ASSERT_LT(index, vertices);
        for (const std::size_t size : {primitive.normals.size(), primitive.tangents.size(), primitive.uvs[0].size(),
                                       primitive.uvs[1].size(), primitive.colors.size()})
            ASSERT_TRUE(size == 0 || size == vertices);
        for (const vec3& position : primitive.positions)
            ASSERT_TRUE(std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z));
        for (const vec3& normal : primitive.normals)
            ASSERT_NEAR(glm::length(normal), 1.0f, 1e-5f);
        ASSERT_TRUE(primitive.material == -1 || below(primitive.material, scene.materials.size()));
    }
    for (const Instance& instance : scene.instances)
        ASSERT_TRUE(below(instance.primitive, scene.primitives.size()));
    for (const Material& material : scene.materials)
        for (const TextureUse* use : {&material.baseColor, &material.metallicRoughness, &material.normal,
                                      &material.occlusion, &material.emissive})
            ASSERT_TRUE(!use->used() || below(use->texture, scene.textures.size()));
    for (const Texture& texture : scene.textures)
        ASSERT_TRUE(below(texture.image, scene.images.size()));
}

} // namespace torrance::test
