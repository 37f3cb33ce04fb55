// What decides the text of a surface shader, and nothing else. Primitives of one key share a pipeline.
#pragma once

#include "scene/material.h"
#include "scene/scene.h"

#include <compare>
#include <string>

namespace torrance {

/// Where the surface comes from.
enum class SurfaceKind
{
    triangles,
    lines,
    points,
    sphere, // analytic
    plane,  // analytic
};

SurfaceKind surfaceKindOf(Topology topology);

struct TextureKey
{
    bool used = false;
    int uvSet = 0;
    bool transformed = false; // not the identity

    auto operator<=>(const TextureKey&) const = default;
};

/// Where a scalar of the material is read from.
enum class ScalarPlace
{
    constant, // the factor alone
    material, // its channel of the texture of scalars
    own,      // a texture of its own
    baseColorAlpha,
    normalAlpha,
    emissiveAlpha,
    words, // its field of texel words
};

struct ShaderKey
{
    SurfaceKind surface = SurfaceKind::triangles;
    bool normals = true;           // points and lines may have none: they are then drawn unlit, as glTF asks
    bool vanishingNormals = false; // interpolated, they may be zero somewhere
    bool colors = false;
    TextureKey baseColor = {}, material = {}, normal = {}, occlusion = {}, emissive = {}, words = {}; // TextureRole
    /// All of them are sampled at one place, which the vertex shader computes: of what set and by which transform is no
    /// matter of the shaders, and the textures' keys say nothing of it.
    bool onePlace = false;
    ScalarPlace roughness = ScalarPlace::constant, metallic = ScalarPlace::constant,
                ambient = ScalarPlace::constant; // ambient: occlusion
    AlphaMode alphaMode = AlphaMode::opaque;
    bool doubleSided = false;
    bool unlit = false;
    bool compensates = false;
    int choice = 0; // ShadingPlan::choices

    auto operator<=>(const ShaderKey&) const = default;
    bool usesUv(int set) const;
    bool tangents() const { return normal.used; } // a normal map stands on tangents
    /// A short name, different for different keys: "triangles baseColor normal mask"; "baseColor1t" where textures are
    /// sampled at places of their own, this at a transformed one of set 1.
    std::string name() const;
};

} // namespace torrance
