// What a material's textures hold at one point. selected.glsl says which there are, and where the scalars lie: ROUGHNESS_TEXEL and its like
// name a member's channel.
struct Texels
{
    vec4 baseColor; // rgb linear
    vec4 material;  // occlusion, roughness, metallic
    vec4 normal;    // as stored, in [0, 1]
    vec4 occlusion; // r
    vec4 emissive;  // rgb linear
};

#ifdef WORDS_UV
#include "material/texel_words.glsl"
#else
#ifdef BASE_COLOR_UV
layout(set = 0, binding = kBindBaseColor) uniform sampler2D baseColorTexture;
#endif
#ifdef MATERIAL_UV
layout(set = 0, binding = kBindScalars) uniform sampler2D scalarsTexture;
#endif
#ifdef NORMAL_UV
layout(set = 0, binding = kBindNormal) uniform sampler2D normalTexture;
#endif
#ifdef OCCLUSION_UV
layout(set = 0, binding = kBindOcclusion) uniform sampler2D occlusionTexture;
#endif
#ifdef EMISSIVE_UV
layout(set = 0, binding = kBindEmissive) uniform sampler2D emissiveTexture;
#endif
#endif

// Roughness, metallic, occlusion and emission of a surface; the base colour and the normal are the caller's.
void applyTexels(inout Surface s, Material material, Texels t)
{
    s.perceptualRoughness = material.roughnessFactor;
    s.metallic = material.metallicFactor;
    s.ior = material.ior;
#ifdef ROUGHNESS_TEXEL
    s.perceptualRoughness *= t.ROUGHNESS_TEXEL;
#endif
#ifdef METALLIC_TEXEL
    s.metallic *= t.METALLIC_TEXEL;
#endif
    s.occlusion = 1.0;
#ifdef OCCLUSION_TEXEL
    s.occlusion += material.occlusionStrength * (t.OCCLUSION_TEXEL - 1.0);
#endif
    s.emissive = material.emissiveFactor;
#ifdef EMISSIVE_UV
    s.emissive *= t.emissive.rgb;
#endif
}

// The unit shading normal from an interpolated one, unit, and its tangent: with the normal map, if there is one, and turned to the side that
// is seen.
vec3 mappedNormal(vec3 n, vec4 tangent, Texels t, float normalScale, float side)
{
#ifdef NORMAL_UV
    n = applyNormalMap(n, tangent, decodeNormal(t.normal.rgb, normalScale));
#endif
    return side * n;
}
