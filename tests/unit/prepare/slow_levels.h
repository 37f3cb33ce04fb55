// The levels of a texture worked out the plain way, texel by texel, one whole level after the other: what the fast way
// is held against, bit by bit.
#pragma once

#include "image/quantize.h"
#include "image/srgb.h"
#include "math/half.h"
#include "math/vector.h"
#include "prepare/texture_levels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace torrance::test {

/// A level in numbers.
struct SlowLevel
{
    int width, height;
    std::vector<vec4> texels;

    vec4& at(int x, int y)
    {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

inline std::uint16_t maximumOf(TexelFormat format)
{
    return format == TexelFormat::rgba8 ? 255 : 65535;
}

inline std::vector<std::uint16_t> codesOf(const TextureImage& image)
{
    std::vector<std::uint16_t> codes;
    const std::size_t bytes = bytesPerTexel(image.format) / 4;
    for (std::size_t i = 0; i < image.texels.size(); i += bytes) {
        std::uint16_t code = 0;
        std::memcpy(&code, image.texels.data() + i, bytes);
        codes.push_back(code);
    }
    return codes;
}

constexpr float kSlowHiddenWeight = 1e-6f; // as texel_codec.cpp has it, for the same reason

inline vec4 slowValue(const std::uint16_t* code, std::uint16_t maximum, const MipRule& rule)
{
    vec4 value;
    for (int c = 0; c < 4; ++c)
        value[c] = dequantized(code[c], maximum);
    for (int c = 0; c < 3; ++c)
        value[c] = rule.content == TexelContent::color    ? srgbDecode(value[c])
                   : rule.content == TexelContent::normal ? value[c] * 2.0f - 1.0f
                                                          : value[c];
    if (rule.weighByAlpha)
        value = vec4(vec3(value) * (value.a + kSlowHiddenWeight), value.a);
    return value;
}

template <typename T>
void appendNumber(std::vector<std::byte>& bytes, T value)
{
    const auto view = std::as_bytes(std::span(&value, 1));
    bytes.insert(bytes.end(), view.begin(), view.end());
}

/// A channel as the device has it: colours as light in halves or floats, normals in 16 bits, others in their file's.
inline void appendStored(std::vector<std::byte>& bytes, float fraction, TexelFormat format, TexelContent content)
{
    const bool wide = format == TexelFormat::rgba16;
    const float clipped = std::clamp(fraction, 0.0f, 1.0f);
    if (content == TexelContent::color)
        wide ? appendNumber(bytes, clipped) : appendNumber(bytes, toHalf(clipped));
    else if (content == TexelContent::normal || wide)
        appendNumber(bytes, quantized(clipped, 65535));
    else
        appendNumber(bytes, static_cast<std::uint8_t>(quantized(clipped, 255)));
}

inline vec4 slowMean(const vec4& mean, const MipRule& rule)
{
    vec3 value(mean);
    float alpha = mean.a;
    if (rule.content == TexelContent::normal) {
        const float length = glm::length(value);
        value = (length > 0.0f ? value / length : vec3(0, 0, 1)) * 0.5f + 0.5f;
        if (rule.lengthInAlpha)
            alpha = length;
    } else if (rule.weighByAlpha)
        value /= mean.a + kSlowHiddenWeight;
    return vec4(value, alpha);
}

/// Weights of the texels of a fine level under texel i of a coarse one: the overlap of [i, i + 1] * fine / coarse with
/// each, over its length; 0 for those that it does not touch.
inline float slowWeight(int i, int fineTexel, int fine, int coarse)
{
    if (fine == 1)
        return 1.0f;
    if (fine % 2 == 0)
        return fineTexel / 2 == i ? 0.5f : 0.0f;
    const int share[] = {coarse - i, coarse, i + 1}; // in units of 1 / fine
    const int place = fineTexel - 2 * i;
    return place < 0 || place > 2 ? 0.0f : static_cast<float>(share[place]) / static_cast<float>(fine);
}

inline SlowLevel slowHalf(SlowLevel& fine)
{
    SlowLevel coarse{std::max(1, fine.width / 2), std::max(1, fine.height / 2), {}};
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x) {
            vec4 mean(0.0f);
            for (int fineY = 2 * y; fineY < std::min(2 * y + 3, fine.height); ++fineY) {
                vec4 row(0.0f);
                for (int fineX = 2 * x; fineX < std::min(2 * x + 3, fine.width); ++fineX)
                    row += slowWeight(x, fineX, fine.width, coarse.width) * fine.at(fineX, fineY);
                mean += slowWeight(y, fineY, fine.height, coarse.height) * row;
            }
            coarse.texels.push_back(mean);
        }
    return coarse;
}

/// A normal map with unit normals in 16 bits and their length, 1, in alpha.
inline TextureImage slowUnitNormals(const TextureImage& image)
{
    TextureImage wide{image.name, image.width, image.height, TexelFormat::rgba16, {}};
    const std::vector<std::uint16_t> codes = codesOf(image);
    for (std::size_t i = 0; i < codes.size(); i += 4) {
        const vec3 normal(slowValue(&codes[i], maximumOf(image.format), {.content = TexelContent::normal}));
        const float length = glm::length(normal);
        const vec3 unit = length > 0.0f ? normal / length : vec3(0, 0, 1);
        const vec4 stored = slowMean(vec4(unit, 1.0f), {.content = TexelContent::normal, .lengthInAlpha = true});
        for (int c = 0; c < 4; ++c)
            appendStored(wide.texels, stored[c], TexelFormat::rgba16, TexelContent::normal);
    }
    return wide;
}

/// All levels, tightly packed.
inline std::vector<std::vector<std::byte>> slowLevels(const TextureImage& file, const MipRule& rule)
{
    const TextureImage image = rule.lengthInAlpha ? slowUnitNormals(file) : file;
    std::vector<std::uint16_t> codes = codesOf(image);
    SlowLevel level{image.width, image.height, {}};
    for (std::size_t i = 0; i < codes.size(); i += 4)
        level.texels.push_back(slowValue(&codes[i], maximumOf(image.format), rule));
    std::vector<std::vector<std::byte>> levels(1);
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const double fraction = codes[i] / static_cast<double>(maximumOf(image.format));
        const bool light = rule.content == TexelContent::color && i % 4 != 3;
        appendStored(levels[0], static_cast<float>(light ? srgbDecode(fraction) : fraction), image.format,
                     rule.content);
    }
    while (level.width > 1 || level.height > 1) {
        level = slowHalf(level);
        levels.emplace_back();
        for (const vec4& texel : level.texels) {
            const vec4 mean = slowMean(texel, rule);
            for (int c = 0; c < 4; ++c)
                appendStored(levels.back(), mean[c], image.format, rule.content);
        }
    }
    return levels;
}

} // namespace torrance::test
