// The colour of the surfaces of one class, whose attributes passes/attributes.frag left: each pixel is shaded once. The stencil lets through
// the pixels of the class.
#include "selected.glsl"
#define PIXEL_RAYS
#include "passes/uniforms.glsl"
#include "shared/constants.h"
#include "material/attributes.glsl"
#include "material/bend_normal.glsl"
#include "material/direction.glsl"
#include "material/normal_map.glsl"
#include "material/surface.glsl"
#include "material/texels.glsl"

#ifdef MATERIAL_LIST
layout(set = 0, binding = kBindMaterial, scalar) uniform MaterialBlock { Material materials[kMaxClassMaterials]; };
#endif

#include "material/shade.glsl"

layout(set = 0, binding = kBindAttributes) uniform usampler2D attributeNormals;
#ifdef ATTRIBUTE_UV
layout(set = 0, binding = kBindAttributes + 1) uniform usampler2D attributeUvs;
#endif
#ifdef POSITION
layout(set = 0, binding = kBindDepth) uniform sampler2D depthPicture;
#endif

layout(location = 0) out vec4 outColor;

// Relative to the eye.
vec3 positionOf(vec3 ray, ivec2 pixel)
{
#ifdef POSITION
    float z = texelFetch(depthPicture, pixel, 0).r;
    vec4 c = frame.viewFromDepth;
    float distance = (c.x * z + c.y) / (c.z * z + c.w); // along the axis of view
    return ray * mix(distance, 1.0, frame.orthographic) + frame.forward * (distance * frame.orthographic);
#else
    return ray; // no light asks where the surface is
#endif
}

#ifdef ATTRIBUTE_UV
Texels readTexels(Material m, vec2 uv, float level)
{
#ifdef WORDS_UV
    return readWords(uv, level + m.wordsLevel);
#else
    Texels t;
#ifdef BASE_COLOR_UV
    t.baseColor = textureLod(baseColorTexture, uv, level + m.levels.x);
#endif
#ifdef MATERIAL_UV
    t.material = textureLod(scalarsTexture, uv, level + m.levels.y);
#endif
#ifdef NORMAL_UV
    t.normal = textureLod(normalTexture, uv, level + m.levels.z);
#endif
#ifdef OCCLUSION_UV
    t.occlusion = textureLod(occlusionTexture, uv, level + m.occlusionLevel);
#endif
#ifdef EMISSIVE_UV
    t.emissive = textureLod(emissiveTexture, uv, level + m.levels.w);
#endif
    return t;
#endif
}
#endif

void main()
{
    readUniforms();
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec4 word = texelFetch(attributeNormals, pixel, 0);
    AttributeBits bits = unpackBits(word.w);
#ifdef MATERIAL_LIST
    Material material = materials[bits.slot];
#endif
    Texels t;
    vec4 tangent = vec4(0.0);
#ifdef ATTRIBUTE_UV
    uvec4 uvWord = texelFetch(attributeUvs, pixel, 0);
    t = readTexels(material, uintBitsToFloat(uvWord.xy), bits.level);
#ifdef TANGENTS
    tangent = vec4(octahedralDirection(uintBitsToFloat(uvWord.zw)), bits.leftHanded ? -1.0 : 1.0);
#endif
#endif
    vec3 ray = frame.corner + gl_FragCoord.x * frame.across + gl_FragCoord.y * frame.down;
    Surface s;
    s.position = positionOf(ray, pixel);
    s.view = directionOf(frame.towardsEye - frame.eyeWeight * ray);
    vec3 n = normalize(uintBitsToFloat(word.xyz));
    s.normal = bendNormal(mappedNormal(n, tangent, t, material.normalScale, bits.back ? -1.0 : 1.0), s.view);
    s.geometricNormal = s.normal; // not kept: no lighting reads it
    s.baseColor = material.baseColorFactor.rgb;
#ifdef BASE_COLOR_UV
    s.baseColor *= t.baseColor.rgb;
#endif
    s.alpha = 1.0;
    applyTexels(s, material, t);
    outColor = vec4(shade(s), 1.0);
}
