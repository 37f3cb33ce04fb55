#ifndef TORRANCE_SHARED_MATERIAL_H
#define TORRANCE_SHARED_MATERIAL_H

#include "shared/language.h"

SHARED_BEGIN

// uv' = (dot(u, (x, y, 1)), dot(v, (x, y, 1)))
struct UvTransform
{
    vec3 u;
    vec3 v;
};

struct Material
{
    vec4 baseColorFactor;
    vec3 emissiveFactor;
    float metallicFactor;
    float roughnessFactor;
    float normalScale;
    float occlusionStrength;
    float alphaCutoff;
    float ior; // of the dielectric part
    UvTransform placeUv; // of all textures, where they are read at one place; else each has its own
    UvTransform baseColorUv;
    UvTransform materialUv; // of the texture of scalars
    UvTransform normalUv;
    UvTransform occlusionUv;
    UvTransform emissiveUv;

    // Read where a surface's attributes are kept apart from its shading.
    uint slot;            // number among the materials of its class
    vec4 levels;          // what the level that is kept differs by for base colour, scalars, normal, emissive
    float occlusionLevel; // and for occlusion

    float wordsLevel; // added to the level of texel words: they are read through no sampler, which adds its bias to others'
};

// As many as are shaded in one go: 64 KiB hold more, a uniform block's limit.
SHARED_UINT(kMaxClassMaterials, 256);

SHARED_END

#endif
