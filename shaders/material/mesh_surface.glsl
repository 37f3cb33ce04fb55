// The surface under a fragment of a primitive: interpolated attributes, factors, textures.
#include "material/bend_normal.glsl"
#include "material/direction.glsl"
#include "material/normal_map.glsl"
#include "material/surface.glsl"
#ifdef AA_TOKUYOSHI
#include "material/aa_tokuyoshi.glsl"
#endif
#ifdef AA_TOKSVIG
#include "material/aa_toksvig.glsl"
#endif

layout(location = 0) in vec3 inPosition;
#ifdef NORMALS
layout(location = 1) in vec3 inNormal;
#endif
#ifdef TANGENTS
layout(location = 2) in vec4 inTangent;
#endif
#ifdef UV0
layout(location = 3) in vec2 inUv0;
#endif
#ifdef UV1
layout(location = 4) in vec2 inUv1;
#endif
#ifdef COLORS
layout(location = 5) in vec4 inColor;
#endif
#ifdef BASE_COLOR_UV_SOURCE
layout(location = 7) in vec2 inBaseColorUv;
#endif
#ifdef METALLIC_ROUGHNESS_UV_SOURCE
layout(location = 8) in vec2 inMetallicRoughnessUv;
#endif
#ifdef NORMAL_UV_SOURCE
layout(location = 9) in vec2 inNormalUv;
#endif
#ifdef OCCLUSION_UV_SOURCE
layout(location = 10) in vec2 inOcclusionUv;
#endif
#ifdef EMISSIVE_UV_SOURCE
layout(location = 11) in vec2 inEmissiveUv;
#endif

#ifdef BASE_COLOR_UV
layout(set = 0, binding = kBindBaseColor) uniform sampler2D baseColorTexture;
#endif
#ifdef METALLIC_ROUGHNESS_UV
layout(set = 0, binding = kBindMetallicRoughness) uniform sampler2D metallicRoughnessTexture;
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

vec4 readBaseColor()
{
    vec4 color = material.baseColorFactor;
#ifdef BASE_COLOR_UV
    color *= texture(baseColorTexture, BASE_COLOR_UV);
#endif
#ifdef COLORS
    color *= inColor;
#endif
    return color;
}

// The normal of the triangle, towards the viewer. Lines and points have none: they face the viewer.
vec3 readGeometricNormal(vec3 view)
{
#ifdef SURFACE_TRIANGLES
    vec3 g = cross(dFdx(inPosition), dFdy(inPosition));
    float length2 = dot(g, g);
    if (length2 > 0.0)
        return g * (dot(g, view) < 0.0 ? -inversesqrt(length2) : inversesqrt(length2));
#endif
    return view;
}

vec3 readNormal(vec3 geometricNormal)
{
#ifdef NORMALS
    if (dot(inNormal, inNormal) == 0.0)
        return geometricNormal; // no direction came out of the vertices
    float side = 1.0;
#ifdef DOUBLE_SIDED
    side = gl_FrontFacing ? 1.0 : -1.0; // glTF 2.0, 3.9.4: the back has its normal reversed before lighting
#endif
    vec3 n = normalize(inNormal);
#ifdef NORMAL_UV
    n = applyNormalMap(n, inTangent, decodeNormal(texture(normalTexture, NORMAL_UV).rgb, material.normalScale));
#endif
    return side * n;
#else
    return geometricNormal;
#endif
}

// The roughness with what the pixel's normals spread over (slot specular_antialiasing).
float antialiasedRoughness(Surface s)
{
    float alpha = max(s.perceptualRoughness * s.perceptualRoughness, kMinAlpha);
    float filtered = alpha;
#if defined(AA_TOKUYOSHI) && defined(NORMALS)
    // Of the vertices' normals, as in the paper: they are interpolated outside of the triangle too, where lavapipe reads zeros for
    // what a normal map is scaled by. Where there is no normal, the face is flat.
    vec3 n = dot(inNormal, inNormal) > 0.0 ? normalize(inNormal) : vec3(0.0);
    filtered = AA_tokuyoshi(dFdx(n), dFdy(n), alpha);
#endif
#ifdef AA_TOKSVIG
    filtered = AA_toksvig(texture(normalTexture, NORMAL_UV).a, alpha);
#endif
    return filtered == alpha ? s.perceptualRoughness : sqrt(filtered);
}

Surface readSurface()
{
    vec4 color = readBaseColor();

    Surface s;
    s.position = inPosition;
    s.view = directionOf(frame.towardsEye - frame.eyeWeight * inPosition);
    s.geometricNormal = readGeometricNormal(s.view);
    s.normal = bendNormal(readNormal(s.geometricNormal), s.view);
    s.baseColor = color.rgb;
    s.alpha = color.a;

    s.perceptualRoughness = material.roughnessFactor;
    s.metallic = material.metallicFactor;
    s.ior = material.ior;
#ifdef METALLIC_ROUGHNESS_UV
    vec4 metallicRoughness = texture(metallicRoughnessTexture, METALLIC_ROUGHNESS_UV);
    s.perceptualRoughness *= metallicRoughness.g;
    s.metallic *= metallicRoughness.b;
#endif
    s.perceptualRoughness = antialiasedRoughness(s);
    s.occlusion = 1.0;
#ifdef OCCLUSION_UV
    s.occlusion += material.occlusionStrength * (texture(occlusionTexture, OCCLUSION_UV).r - 1.0);
#endif
    s.emissive = material.emissiveFactor;
#ifdef EMISSIVE_UV
    s.emissive *= texture(emissiveTexture, EMISSIVE_UV).rgb;
#endif
    return s;
}
