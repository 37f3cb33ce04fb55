// Textures of a material whose texels lie together as words: shared/texel_words.h. They are filtered here, linearly between texels and
// levels (ONE_LEVEL: on the nearer of two): a software rasterizer then fetches a texel of all of them at once, where it would work out and fetch each by itself.
#include "shared/texel_words.h"

layout(set = 0, binding = kBindTexelWords) uniform usampler2D wordsTexture;

// The texels round a place on one level, repeated beyond the sides.
struct WordPlace
{
    ivec2 least, greatest;
    vec2 beyond; // of the way from the least to the greatest
};

WordPlace wordPlace(vec2 uv, ivec2 size)
{
    vec2 place = (uv - floor(uv)) * vec2(size) - 0.5;
    vec2 corner = clamp(floor(place), vec2(-1.0), vec2(size) - 1.0); // also of what is no number: nothing beyond the sides is fetched
    ivec2 first = ivec2(corner);
    ivec2 next = first + 1;
    return WordPlace(ivec2(first.x < 0 ? size.x - 1 : first.x, first.y < 0 ? size.y - 1 : first.y),
                     ivec2(next.x < size.x ? next.x : 0, next.y < size.y ? next.y : 0), place - corner);
}

// Weighted sums of fields, each times two to the power of where it lies: a field in the middle of a word need not be moved to become a float.
struct WordSums
{
    vec3 baseColor; // of squares
    vec3 normal;
    vec3 emissive; // of squares
    vec3 scalars;  // occlusion, roughness, metallic
};

vec3 squared(ivec3 v)
{
    return vec3(v) * vec3(v);
}

// Signed numbers become floats in one instruction, unsigned ones do not; none of these is negative.
int field(uint word, uint bits, uint shift)
{
    return int(word & (((1u << bits) - 1u) << shift));
}

int upperField(uint word, uint shift)
{
    return int(word >> shift);
}

void addWords(inout WordSums sums, float weight, uvec4 word)
{
#ifdef BASE_COLOR_UV
    sums.baseColor += weight * squared(ivec3(field(word.x, kColorBits, 0u), field(word.x, kColorBits, kColorBits), field(word.y, kColorBits, 0u)));
#endif
#ifdef NORMAL_UV
    sums.normal += weight * vec3(field(word.z, kNormalBits, 0u), field(word.z, kNormalBits, kNormalBits), field(word.w, kNormalBits, 0u));
#endif
#ifdef EMISSIVE_UV
    sums.emissive += weight * squared(ivec3(field(word.y, kColorBits, kColorBits), field(word.w, kColorBits, kGreenShift), upperField(word.y, kBlueShift)));
#endif
#ifdef OCCLUSION_TEXEL
    sums.scalars.x += weight * float(upperField(word.w, kOcclusionShift));
#endif
#ifdef ROUGHNESS_TEXEL
    sums.scalars.y += weight * float(upperField(word.x, kRoughnessShift));
#endif
#ifdef METALLIC_TEXEL
    sums.scalars.z += weight * float(upperField(word.z, kMetallicShift));
#endif
}

// What one level holds at a place.
void addLevel(inout WordSums sums, float weight, vec2 uv, int level, ivec2 size)
{
    WordPlace p = wordPlace(uv, max(size >> level, ivec2(1)));
    vec2 b = p.beyond, a = 1.0 - b;
    addWords(sums, weight * a.x * a.y, texelFetch(wordsTexture, p.least, level));
    addWords(sums, weight * b.x * a.y, texelFetch(wordsTexture, ivec2(p.greatest.x, p.least.y), level));
    addWords(sums, weight * a.x * b.y, texelFetch(wordsTexture, ivec2(p.least.x, p.greatest.y), level));
    addWords(sums, weight * b.x * b.y, texelFetch(wordsTexture, p.greatest, level));
}

// `level` of detail: 0 = the finest there is.
Texels readWords(vec2 uv, float level)
{
    ivec2 size = textureSize(wordsTexture, 0);
    float last = float(textureQueryLevels(wordsTexture) - 1);
    float within = clamp(level, 0.0, last);
    WordSums sums = WordSums(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
#ifdef ONE_LEVEL
    addLevel(sums, 1.0, uv, int(ceil(within - 0.5)), size);
#else
    float finer = floor(within), coarser = min(finer + 1.0, last);
    addLevel(sums, 1.0 - (within - finer), uv, int(finer), size);
    addLevel(sums, within - finer, uv, int(coarser), size);
#endif

    const vec3 kBaseColor = vec3(kColorField, kColorField << kColorBits, kColorField);
    const vec3 kNormal = vec3(kNormalField, kNormalField << kNormalBits, kNormalField);
    const vec3 kEmissive = vec3(kColorField << kColorBits, kColorField << kGreenShift, kBlueField);
    const vec3 kScalars = vec3(kOcclusionField, kRoughnessField, kMetallicField);
    Texels t;
    t.baseColor = vec4(sums.baseColor * (1.0 / (kBaseColor * kBaseColor)), 1.0);
    t.normal = vec4(sums.normal * (1.0 / kNormal), 1.0);
    t.emissive = vec4(sums.emissive * (1.0 / (kEmissive * kEmissive)), 1.0);
    t.material = vec4(sums.scalars * (1.0 / kScalars), 1.0);
    return t;
}
