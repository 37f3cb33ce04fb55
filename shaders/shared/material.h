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
    UvTransform baseColorUv;
    UvTransform metallicRoughnessUv;
    UvTransform normalUv;
    UvTransform occlusionUv;
    UvTransform emissiveUv;
};

SHARED_END

#endif
