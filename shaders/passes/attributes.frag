// What the shading of a pixel needs of its surface, unshaded: interpolated as the forward path has it, as bits of 32-bit floats, for
// passes/resolve.frag. shaders/material/attributes.glsl says what is where.
#include "selected.glsl"
#include "passes/surface_inputs.glsl"
#include "material/attributes.glsl"

layout(location = 0) out uvec4 outNormal;
#ifdef ATTRIBUTES_HAVE_UV
layout(location = 1) out uvec4 outUv;
#endif

#ifdef WORDS_UV
#define LEVEL_SAMPLER usampler2D
#else
#define LEVEL_SAMPLER sampler2D
#endif
#ifdef ATTRIBUTE_UV
layout(set = 0, binding = kBindLevel) uniform LEVEL_SAMPLER levelTexture;
#endif

// The interpolated normal, of any length but zero.
vec3 attributeNormal()
{
#ifdef VANISHING_NORMALS
    if (dot(inNormal, inNormal) > 0.0)
        return inNormal;
    // As readGeometricNormal has it; but whoever sees the triangle sees its x and y turn one way, so that nothing is read of the frame.
    vec3 g = cross(dFdy(inPosition), dFdx(inPosition));
    float length2 = dot(g, g);
    const vec3 any = vec3(0.0, 0.0, 1.0); // too small to have a side
    return (length2 > 0.0 ? g * inversesqrt(length2) : any) * seenSide(); // turned back when it is read
#else
    return inNormal;
#endif
}

void main()
{
#ifdef ALPHA_MASK
    if (baseColorOf(readTexels()).a < material.alphaCutoff)
        discard;
#endif
    AttributeBits bits = AttributeBits(material.slot, seenSide() < 0.0, false, 0.0);
#ifdef ATTRIBUTES_HAVE_UV
    vec2 uv = vec2(0.0);
    vec2 tangent = vec2(0.0);
#ifdef ATTRIBUTE_UV
    uv = ATTRIBUTE_UV;
#if defined(EXACT_LEVEL) || defined(WORDS_UV)
    bits.level = levelOfDetail(uv, vec2(textureSize(levelTexture, 0)));
#else
    bits.level = textureQueryLod(levelTexture, uv).y; // the device's own: its logarithm may be an approximate one
#endif
#endif
#ifdef TANGENTS
    tangent = octahedral(inTangent.xyz);
    bits.leftHanded = inTangent.w < 0.0;
#endif
    outUv = uvec4(floatBitsToUint(uv), floatBitsToUint(tangent));
#endif
    outNormal = uvec4(floatBitsToUint(attributeNormal()), packBits(bits));
}
