// Kinds of texels: what codes of a file are averaged as, and how they and their means lie on the device. For the codecs
// of this folder, which are made of them.
#pragma once

#include "image/quantize.h"
#include "image/srgb.h"
#include "math/half.h"
#include "math/half4.h"
#include "prepare/texel_codec.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace torrance::texels {

/// The weight of a wholly transparent colour beside an opaque one: so little that it cannot be seen, and enough that
/// where all is transparent the colours still have a mean.
constexpr float kHiddenWeight = 1e-6f;

template <typename Code>
constexpr std::uint16_t kMaximum = std::numeric_limits<Code>::max();

template <typename Code>
constexpr std::size_t kCodes = std::size_t(kMaximum<Code>) + 1;

template <typename Code>
std::array<Code, 4> codesAt(const std::byte* texels, std::size_t i)
{
    std::array<Code, 4> codes;
    std::memcpy(codes.data(), texels + i * sizeof codes, sizeof codes);
    return codes;
}

inline Float4 clippedToUnit(Float4 value)
{
    return least(greatest(value, splat(0.0f)), splat(1.0f));
}

/// The values of all codes, by code.
template <typename Code, typename Value, typename Function>
std::vector<Value> tabulated(const Function& valueOf)
{
    std::vector<Value> table(kCodes<Code>);
    for (std::size_t code = 0; code < table.size(); ++code)
        table[code] = valueOf(static_cast<std::uint16_t>(code));
    return table;
}

template <typename Code>
const std::vector<float>& fractionTable()
{
    static const auto table =
        tabulated<Code, float>([](std::uint16_t code) { return dequantized(code, kMaximum<Code>); });
    return table;
}

/// Means of four texels.
using Four = std::array<Float4, 4>;

template <typename Code>
using FourTexels = std::array<Code, 16>;

// Kinds of texels. Each has value(), what a texel is averaged as; stored(), a texel of the file for the device; and
// nearest(), means for the device.

template <typename CodeType>
struct Stored // codes lie on the device as they are
{
    using Code = CodeType;
    using OnDevice = CodeType;
    static constexpr TexelStorage kStorage = sizeof(Code) == 1 ? TexelStorage::unorm8 : TexelStorage::unorm16;

    const std::vector<float>& fractionOf = fractionTable<Code>();

    std::array<OnDevice, 4> stored(const std::array<Code, 4>& code) const { return code; }
    void rounded(const Four& fractions, FourTexels<OnDevice>& texels) const
    {
        const auto code = [&](std::size_t i) { return roundedProduct(clippedToUnit(fractions[i]), kMaximum<Code>); };
        pack(code(0), code(1), code(2), code(3), texels.data());
    }
};

/// Codes lie on the device in 16 bits, exactly, and means between them.
template <typename CodeType>
struct Widened
{
    using Code = CodeType;
    using OnDevice = std::uint16_t;
    static constexpr TexelStorage kStorage = TexelStorage::unorm16;
    static constexpr int kFactor = kMaximum<OnDevice> / kMaximum<Code>;

    const std::vector<float>& fractionOf = fractionTable<Code>();

    std::array<OnDevice, 4> stored(const std::array<Code, 4>& code) const
    {
        std::array<OnDevice, 4> wide;
        for (std::size_t c = 0; c < wide.size(); ++c)
            wide[c] = static_cast<OnDevice>(kFactor * code[c]);
        return wide;
    }
    void rounded(const Four& fractions, FourTexels<OnDevice>& texels) const
    {
        const auto code = [&](std::size_t i) {
            return roundedProduct(clippedToUnit(fractions[i]), kMaximum<OnDevice>);
        };
        pack(code(0), code(1), code(2), code(3), texels.data());
    }
};

template <typename CodeType>
struct Data : Stored<CodeType>
{
    using Code = CodeType;

    Float4 value(const std::array<Code, 4>& code) const
    {
        const float* of = this->fractionOf.data();
        return Float4{of[code[0]], of[code[1]], of[code[2]], of[code[3]]};
    }
    void nearest(const Four& means, FourTexels<Code>& texels) const { this->rounded(means, texels); }
};

/// Four vectors over their lengths, which are returned; (0, 0, 1) where there is none.
inline Float4 makeUnit(Float4& x, Float4& y, Float4& z)
{
    const Float4 length = squareRoot(x * x + y * y + z * z), nothing = splat(0.0f);
    x = length > nothing ? x / length : nothing;
    y = length > nothing ? y / length : nothing;
    z = length > nothing ? z / length : splat(1.0f);
    return length;
}

// Means of normals rounded to the 8 bits of their file were all of a minified picture's error that no method of shading
// could lower: 1.4 % of a water bottle's light in 256 x 256 pixels, and 0.2 % without.
template <typename CodeType, bool kLengthInAlpha>
struct Normals : Widened<CodeType>
{
    using Code = CodeType;

    Float4 value(const std::array<Code, 4>& code) const
    {
        const float* of = this->fractionOf.data();
        const Float4 stored = {of[code[0]], of[code[1]], of[code[2]], of[code[3]]};
        return stored * Float4{2, 2, 2, 1} - Float4{1, 1, 1, 0};
    }
    void nearest(Four means, FourTexels<std::uint16_t>& texels) const
    {
        auto& [x, y, z, alpha] = means; // of the four texels, once they are transposed
        transpose(x, y, z, alpha);
        const Float4 length = makeUnit(x, y, z);
        for (Float4* channel : {&x, &y, &z})
            *channel = *channel * 0.5f + 0.5f;
        if (kLengthInAlpha)
            alpha = length;
        transpose(x, y, z, alpha);
        this->rounded(means, texels);
    }
};

template <typename Code>
const std::vector<float>& linearTable()
{
    static const auto table =
        tabulated<Code, float>([](std::uint16_t code) { return srgbDecode(dequantized(code, kMaximum<Code>)); });
    return table;
}

template <typename Decode>
std::vector<std::uint16_t> halves(const Decode& decode)
{
    return tabulated<std::uint8_t, std::uint16_t>(
        [&](std::uint16_t code) { return toHalf(static_cast<float>(decode(code / 255.0))); });
}

inline const std::vector<std::uint16_t>& halfColors()
{
    static const auto table = halves([](double v) { return srgbDecode(v); });
    return table;
}

inline const std::vector<std::uint16_t>& halfFractions()
{
    static const auto table = halves([](double v) { return v; });
    return table;
}

// lavapipe's own decoding of an sRGB format is a polynomial, off by 1e-3 in the middle of the curve and by 1e-2 in the
// dark (tests/image/surfaces.cpp). Halves are as fast to sample, at twice the memory.
struct Color8Storage
{
    using Code = std::uint8_t;
    using OnDevice = std::uint16_t;
    static constexpr TexelStorage kStorage = TexelStorage::half;

    const std::vector<std::uint16_t>& colors = halfColors();
    const std::vector<std::uint16_t>& alphas = halfFractions();

    std::array<OnDevice, 4> stored(const std::array<Code, 4>& code) const
    {
        return {colors[code[0]], colors[code[1]], colors[code[2]], alphas[code[3]]};
    }
    void rounded(const Four& lights, FourTexels<OnDevice>& texels) const
    {
        pack(halfBits(lights[0]), halfBits(lights[1]), halfBits(lights[2]), halfBits(lights[3]), texels.data());
    }
};

inline const std::vector<float>& singleColors()
{
    static const auto table = tabulated<std::uint16_t, float>(
        [](std::uint16_t code) { return static_cast<float>(srgbDecode(code / 65535.0)); });
    return table;
}

// There is no 16-bit sRGB format: the curve is undone here, in float, so that filtering happens in linear light.
struct Color16Storage
{
    using Code = std::uint16_t;
    using OnDevice = float;
    static constexpr TexelStorage kStorage = TexelStorage::single;

    const std::vector<float>& colors = singleColors();
    const std::vector<float>& alphas = fractionTable<Code>();

    std::array<OnDevice, 4> stored(const std::array<Code, 4>& code) const
    {
        return {colors[code[0]], colors[code[1]], colors[code[2]], alphas[code[3]]};
    }
    void rounded(const Four& lights, FourTexels<OnDevice>& texels) const
    {
        std::memcpy(texels.data(), lights.data(), sizeof texels);
    }
};

template <typename Storage, bool kWeighByAlpha>
struct Colors : Storage
{
    using Code = typename Storage::Code;

    const std::vector<float>& light = linearTable<Code>();
    const std::vector<float>& fractions = fractionTable<Code>();

    Float4 value(const std::array<Code, 4>& code) const
    {
        const float* of = light.data();
        const float alpha = fractions[code[3]];
        const Float4 color = {of[code[0]], of[code[1]], of[code[2]], alpha};
        if (!kWeighByAlpha)
            return color;
        const float weight = alpha + kHiddenWeight;
        return color * Float4{weight, weight, weight, 1.0f};
    }
    void nearest(Four means, FourTexels<typename Storage::OnDevice>& texels) const
    {
        for (Float4& mean : means) {
            if (kWeighByAlpha) {
                const float weight = mean[3] + kHiddenWeight;
                mean /= Float4{weight, weight, weight, 1.0f};
            }
            mean = clippedToUnit(mean);
        }
        this->rounded(means, texels);
    }
};

template <typename Kind>
struct Rows
{
    using Code = typename Kind::Code;
    static constexpr std::size_t kTexelBytes = bytesPerTexel(Kind::kStorage);

    static void decode(const std::byte* codes, std::size_t count, Float4* values)
    {
        const Kind kind;
        for (std::size_t i = 0; i < count; ++i)
            values[i] = kind.value(codesAt<Code>(codes, i));
    }
    static void halve(const std::byte* upper, const std::byte* lower, std::size_t count, Float4* means)
    {
        const Kind kind;
        const auto half = [&](const std::byte* row, std::size_t i) {
            return 0.25f * (kind.value(codesAt<Code>(row, 2 * i)) + kind.value(codesAt<Code>(row, 2 * i + 1)));
        };
        for (std::size_t i = 0; i < count; ++i)
            means[i] = half(upper, i) + half(lower, i);
    }
    static void store(const std::byte* codes, std::size_t count, std::byte* texels)
    {
        const Kind kind;
        for (std::size_t i = 0; i < count; ++i) {
            const auto stored = kind.stored(codesAt<Code>(codes, i));
            std::memcpy(texels + i * kTexelBytes, stored.data(), kTexelBytes);
        }
    }
    static void encode(const Float4* means, std::size_t count, std::byte* texels)
    {
        const Kind kind;
        Four four;
        FourTexels<typename Kind::OnDevice> stored;
        for (std::size_t i = 0; i < count; i += four.size()) {
            const std::size_t some = std::min(count - i, four.size());
            std::copy_n(means + i, some, four.begin());
            std::fill(four.begin() + static_cast<std::ptrdiff_t>(some), four.end(), splat(0.0f));
            kind.nearest(four, stored);
            std::memcpy(texels + i * kTexelBytes, stored.data(), some * kTexelBytes);
        }
    }
};

} // namespace torrance::texels
