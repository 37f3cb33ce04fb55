// The surface under a fragment of a primitive: interpolated attributes, factors, textures.
#include "material/bend_normal.glsl"
#include "material/direction.glsl"
#include "material/normal_map.glsl"
#include "material/surface.glsl"
#include "material/texels.glsl"
#if defined(EXACT_LEVEL) || defined(WORDS_UV)
#include "material/level_of_detail.glsl"
#endif
#ifdef AA_TOKUYOSHI
#include "material/aa_tokuyoshi.glsl"
#endif
#ifdef AA_TOKSVIG
#include "material/aa_toksvig.glsl"
#endif

#ifdef AT_SAMPLES
#define INPUT sample in
#else
#define INPUT in
#endif
layout(location = 0) INPUT vec3 inPosition;
#ifdef NORMALS
layout(location = 1) INPUT vec3 inNormal;
#endif
#ifdef TANGENTS
layout(location = 2) INPUT vec4 inTangent;
#endif
#ifdef UV0
layout(location = 3) INPUT vec2 inUv0;
#endif
#ifdef UV1
layout(location = 4) INPUT vec2 inUv1;
#endif
#ifdef COLORS
layout(location = 5) INPUT vec4 inColor;
#endif
#ifdef BASE_COLOR_UV_SOURCE
layout(location = 7) INPUT vec2 inBaseColorUv;
#endif
#ifdef MATERIAL_UV_SOURCE
layout(location = 8) INPUT vec2 inMaterialUv;
#endif
#ifdef NORMAL_UV_SOURCE
layout(location = 9) INPUT vec2 inNormalUv;
#endif
#ifdef OCCLUSION_UV_SOURCE
layout(location = 10) INPUT vec2 inOcclusionUv;
#endif
#ifdef EMISSIVE_UV_SOURCE
layout(location = 11) INPUT vec2 inEmissiveUv;
#endif

// Not a function: each read stands where it is made, and can be counted.
#ifdef EXACT_LEVEL
#define READ_TEXTURE(map, uv) textureLod(map, uv, levelOfDetail(uv, vec2(textureSize(map, 0))))
#else
#define READ_TEXTURE(map, uv) texture(map, uv)
#endif

Texels readTexels()
{
#ifdef WORDS_UV
    return readWords(WORDS_UV, levelOfDetail(WORDS_UV, vec2(textureSize(wordsTexture, 0))) + material.wordsLevel);
#else
    Texels t;
#ifdef BASE_COLOR_UV
    t.baseColor = READ_TEXTURE(baseColorTexture, BASE_COLOR_UV);
#endif
#ifdef MATERIAL_UV
    t.material = READ_TEXTURE(scalarsTexture, MATERIAL_UV);
#endif
#ifdef NORMAL_UV
    t.normal = READ_TEXTURE(normalTexture, NORMAL_UV);
#endif
#ifdef OCCLUSION_UV
    t.occlusion = READ_TEXTURE(occlusionTexture, OCCLUSION_UV);
#endif
#ifdef EMISSIVE_UV
    t.emissive = READ_TEXTURE(emissiveTexture, EMISSIVE_UV);
#endif
    return t;
#endif
}

// Linear, with alpha; alpha is the texel's own where ALPHA_MASK or ALPHA_BLEND asks for it.
vec4 baseColorOf(Texels t)
{
    vec4 color = material.baseColorFactor;
#ifdef BASE_COLOR_UV
#if defined(ALPHA_MASK) || defined(ALPHA_BLEND)
    color *= t.baseColor;
#else
    color.rgb *= t.baseColor.rgb;
#endif
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

// glTF 2.0, 3.9.4: the back of a double-sided surface has its normal reversed before lighting.
float seenSide()
{
#ifdef SIDES
    return gl_FrontFacing ? 1.0 : -1.0;
#else
    return 1.0;
#endif
}

vec3 readNormal(Texels t, vec3 geometricNormal)
{
#ifdef NORMALS
#ifdef VANISHING_NORMALS
    if (dot(inNormal, inNormal) == 0.0)
        return geometricNormal; // no direction came out of the vertices
#endif
#ifdef TANGENTS
    vec4 tangent = inTangent;
#else
    const vec4 tangent = vec4(0.0);
#endif
    return mappedNormal(normalize(inNormal), tangent, t, material.normalScale, seenSide());
#else
    return geometricNormal;
#endif
}

// The roughness with what the pixel's normals spread over (slot specular_antialiasing).
float antialiasedRoughness(Surface s, Texels t)
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
    filtered = AA_toksvig(t.normal.a, alpha);
#endif
    return filtered == alpha ? s.perceptualRoughness : sqrt(filtered);
}

Surface readSurface()
{
    Texels t = readTexels();
    vec4 color = baseColorOf(t);

    Surface s;
    s.position = inPosition;
    s.view = directionOf(frame.towardsEye - frame.eyeWeight * inPosition);
    s.geometricNormal = readGeometricNormal(s.view);
    s.normal = bendNormal(readNormal(t, s.geometricNormal), s.view);
    s.baseColor = color.rgb;
    s.alpha = color.a;
    applyTexels(s, material, t);
    s.perceptualRoughness = antialiasedRoughness(s, t);
    return s;
}
