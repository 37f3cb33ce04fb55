// A pixel's surface as passes/attributes.frag leaves it and passes/resolve.frag reads it:
//   picture 0: the interpolated normal, three floats, and AttributeBits
//   picture 1: texture coordinates, two floats, and the direction of the tangent, two floats of its octahedron
struct AttributeBits
{
    uint slot;       // of the material among those of its class: 8 bits
    bool back;       // the far side of a double-sided surface is seen: the normal is to be turned
    bool leftHanded; // the tangent's sign
    float level;     // of detail: 0 = the finest, kept in steps of 2^-16 up to 16
};

const float kNoDirection = 2.0; // outside of the square
const float kLevelSteps = 65536.0;
const float kGreatestLevel = 15.999; // of a texture 64 thousand texels a side
const uint kLevelShift = 10u;

uint packBits(AttributeBits bits)
{
    uint level = uint(clamp(bits.level, 0.0, kGreatestLevel) * kLevelSteps + 0.5);
    return bits.slot | (bits.back ? 1u << 8u : 0u) | (bits.leftHanded ? 1u << 9u : 0u) | level << kLevelShift;
}

AttributeBits unpackBits(uint word)
{
    return AttributeBits(word & 255u, (word & 1u << 8u) != 0u, (word & 1u << 9u) != 0u, float(word >> kLevelShift) / kLevelSteps);
}

// A point of the octahedron's upper half for one of the lower half, and the other way round.
vec2 foldedOver(vec2 p)
{
    return (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
}

// A direction as a point of the square: Meyer et al. 2010, On Floating-Point Normal Vectors. In floats the direction keeps its bits. d is
// of any length; of zero length it becomes what octahedralDirection reads as no direction.
vec2 octahedral(vec3 d)
{
    float size = abs(d.x) + abs(d.y) + abs(d.z);
    if (!(size > 0.0))
        return vec2(kNoDirection);
    vec2 p = d.xy / size;
    return d.z >= 0.0 ? p : foldedOver(p);
}

vec3 octahedralDirection(vec2 p)
{
    if (p.x == kNoDirection)
        return vec3(0.0);
    float z = 1.0 - abs(p.x) - abs(p.y);
    return vec3(z >= 0.0 ? p : foldedOver(p), z);
}
