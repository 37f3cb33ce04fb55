#include "prepare/mips.h"

#include "core/parallel.h"
#include "image/quantize.h"
#include "image/srgb.h"
#include "math/vector.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>

namespace torrance {
namespace {

/// The weight of a wholly transparent colour beside an opaque one: so little that it cannot be seen, and enough that
/// where all is transparent the colours still have a mean.
constexpr float kHiddenWeight = 1e-6f;
constexpr std::size_t kTexelsPerTask = 1u << 14;

/// Exact rounding of linear light to 8-bit sRGB without a power per texel.
class SrgbCodes
{
public:
    SrgbCodes()
    {
        for (std::size_t i = 0; i < boundary.size(); ++i)
            boundary[i] = static_cast<float>(srgbDecode((static_cast<double>(i) + 0.5) / 255.0));
        for (std::size_t i = 0; i < atLeast.size(); ++i)
            atLeast[i] = static_cast<std::uint8_t>(
                std::upper_bound(boundary.begin(), boundary.end(), static_cast<float>(i) / kSteps) - boundary.begin());
    }

    /// x in [0, 1].
    std::uint8_t encode(float x) const
    {
        std::size_t code = atLeast[static_cast<std::size_t>(x * kSteps)];
        while (code < boundary.size() && x >= boundary[code])
            ++code;
        return static_cast<std::uint8_t>(code);
    }

private:
    static constexpr float kSteps = 4096.0f; // finer than the code values are anywhere
    std::array<float, 255> boundary;         // between code i and i + 1
    std::array<std::uint8_t, static_cast<std::size_t>(kSteps) + 1> atLeast;
};

const SrgbCodes& srgbCodes()
{
    static const SrgbCodes codes;
    return codes;
}

/// quantized() without its call per texel: adding 1.5 * 2^52 leaves a double no bits below one, rounded half to even.
std::uint16_t rounded(float value, double maximum)
{
    constexpr double kNoFraction = 0x1.8p52;
    return static_cast<std::uint16_t>(static_cast<double>(value) * maximum + kNoFraction - kNoFraction);
}

/// How texels become numbers that may be averaged, and back.
class Codec
{
public:
    const TexelFormat format;

    Codec(TexelFormat texelFormat, const MipRule& mipRule) : format(texelFormat), rule(mipRule)
    {
        const std::uint16_t maximum = format == TexelFormat::rgba8 ? 255 : 65535;
        for (std::uint32_t code = 0; code <= maximum; ++code) {
            const float stored = dequantized(static_cast<std::uint16_t>(code), maximum);
            alphaOf.push_back(stored);
            colorOf.push_back(rule.content == TexelContent::color    ? srgbDecode(stored)
                              : rule.content == TexelContent::normal ? stored * 2.0f - 1.0f
                                                                     : stored);
        }
    }

    /// `count` texels, one after the other.
    void decode(const std::byte* texels, std::size_t count, vec4* out) const
    {
        if (format == TexelFormat::rgba8)
            decodeAs<std::uint8_t>(texels, count, out);
        else
            decodeAs<std::uint16_t>(texels, count, out);
        if (rule.weighByAlpha)
            for (std::size_t i = 0; i < count; ++i)
                out[i] = vec4(vec3(out[i]) * (out[i].a + kHiddenWeight), out[i].a);
    }

    void encode(const vec4& mean, std::byte* texel) const
    {
        vec3 value(mean);
        float alpha = mean.a;
        if (rule.content == TexelContent::normal) {
            const float length = glm::length(value);
            if (rule.lengthInAlpha)
                alpha = length;
            value = (length > 0.0f ? value / length : vec3(0, 0, 1)) * 0.5f + 0.5f;
        } else if (rule.weighByAlpha)
            value /= mean.a + kHiddenWeight;
        encodeChannels(vec4(glm::clamp(value, 0.0f, 1.0f), std::clamp(alpha, 0.0f, 1.0f)), texel);
    }

private:
    template <typename Code>
    void decodeAs(const std::byte* texels, std::size_t count, vec4* out) const
    {
        for (std::size_t i = 0; i < count; ++i) {
            std::array<Code, 4> code;
            std::memcpy(code.data(), texels + i * sizeof code, sizeof code);
            out[i] = vec4(colorOf[code[0]], colorOf[code[1]], colorOf[code[2]], alphaOf[code[3]]);
        }
    }

    void encodeChannels(const vec4& value, std::byte* texel) const
    {
        for (int c = 0; c < 4; ++c) {
            const bool curved = rule.content == TexelContent::color && c < 3;
            if (format == TexelFormat::rgba8) {
                texel[c] = std::byte(curved ? srgbCodes().encode(value[c])
                                            : static_cast<std::uint8_t>(rounded(value[c], 255.0)));
                continue;
            }
            const std::uint16_t code = rounded(curved ? srgbEncode(value[c]) : value[c], 65535.0);
            std::memcpy(texel + 2 * c, &code, sizeof code);
        }
    }

    MipRule rule;
    std::vector<float> colorOf, alphaOf; // by code
};

/// The texels of the finer level under one of the coarser, along one axis.
struct Taps
{
    int first;
    int count;
    std::array<float, 3> weight;
};

/// Texel i of `coarse` covers [i, i + 1] * fine / coarse of the finer ones.
Taps tapsOf(int i, int fine, int coarse)
{
    if (fine == 1)
        return {0, 1, {1.0f}};
    if (fine % 2 == 0)
        return {2 * i, 2, {0.5f, 0.5f}};
    const float whole = static_cast<float>(fine);
    return {2 * i,
            3,
            {static_cast<float>(coarse - i) / whole, static_cast<float>(coarse) / whole,
             static_cast<float>(i + 1) / whole}};
}

struct Means
{
    int width = 0;
    int height = 0;
    std::vector<vec4> texels;
};

/// One row of the coarser level; `fineRow(y)` gives a row of the finer one.
template <typename FineRow>
void reduceRow(int y, int fineWidth, int fineHeight, Means& coarse, const FineRow& fineRow)
{
    vec4* out = coarse.texels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(coarse.width);
    const Taps rows = tapsOf(y, fineHeight, coarse.height);
    for (int j = 0; j < rows.count; ++j) {
        const vec4* in = fineRow(rows.first + j);
        const float weight = rows.weight[static_cast<std::size_t>(j)];
        if (fineWidth % 2 == 0) { // the common case, without its taps
            for (int x = 0; x < coarse.width; ++x)
                out[x] += (0.5f * weight) * (in[2 * x] + in[2 * x + 1]);
            continue;
        }
        for (int x = 0; x < coarse.width; ++x) {
            const Taps columns = tapsOf(x, fineWidth, coarse.width);
            vec4 sum(0.0f);
            for (int i = 0; i < columns.count; ++i)
                sum += columns.weight[static_cast<std::size_t>(i)] * in[columns.first + i];
            out[x] += weight * sum;
        }
    }
}

Means emptyMeans(int fineWidth, int fineHeight)
{
    Means means{std::max(1, fineWidth / 2), std::max(1, fineHeight / 2), {}};
    means.texels.assign(static_cast<std::size_t>(means.width) * static_cast<std::size_t>(means.height), vec4(0.0f));
    return means;
}

std::size_t rowsPerTask(int width)
{
    return std::max<std::size_t>(1, kTexelsPerTask / static_cast<std::size_t>(width));
}

/// Level 1 straight from the stored texels, so that level 0 never exists in float.
Means reduceImage(const TextureImage& image, const Codec& codec)
{
    Means coarse = emptyMeans(image.width, image.height);
    const std::size_t stride = bytesPerTexel(image.format);
    parallelFor(static_cast<std::size_t>(coarse.height), rowsPerTask(image.width), [&](std::size_t y) {
        std::vector<vec4> row(static_cast<std::size_t>(image.width));
        reduceRow(static_cast<int>(y), image.width, image.height, coarse, [&](int fineY) {
            codec.decode(image.texels.data() + static_cast<std::size_t>(fineY) * row.size() * stride, row.size(),
                         row.data());
            return row.data();
        });
    });
    return coarse;
}

Means reduceMeans(const Means& fine)
{
    Means coarse = emptyMeans(fine.width, fine.height);
    parallelFor(static_cast<std::size_t>(coarse.height), rowsPerTask(fine.width), [&](std::size_t y) {
        reduceRow(static_cast<int>(y), fine.width, fine.height, coarse, [&](int fineY) {
            return fine.texels.data() + static_cast<std::size_t>(fineY) * static_cast<std::size_t>(fine.width);
        });
    });
    return coarse;
}

TextureImage storeMeans(const Means& means, const Codec& codec, const std::string& name)
{
    TextureImage image{name, means.width, means.height, codec.format, {}};
    const std::size_t stride = bytesPerTexel(codec.format);
    image.texels.resize(means.texels.size() * stride);
    parallelFor(means.texels.size(), kTexelsPerTask,
                [&](std::size_t i) { codec.encode(means.texels[i], image.texels.data() + i * stride); });
    return image;
}

} // namespace

TextureImage wideNormals(const TextureImage& normals)
{
    const Codec from(normals.format, {.content = TexelContent::normal});
    const Codec to(TexelFormat::rgba16, {.content = TexelContent::normal, .lengthInAlpha = true});
    const std::size_t count = static_cast<std::size_t>(normals.width) * static_cast<std::size_t>(normals.height);
    TextureImage wide{normals.name, normals.width, normals.height, TexelFormat::rgba16, {}};
    wide.texels.resize(count * bytesPerTexel(wide.format));
    parallelFor(count, kTexelsPerTask, [&](std::size_t i) {
        vec4 texel;
        from.decode(normals.texels.data() + i * bytesPerTexel(normals.format), 1, &texel);
        const float length = glm::length(vec3(texel));
        to.encode(vec4(length > 0.0f ? vec3(texel) / length : vec3(0, 0, 1), 1.0f),
                  wide.texels.data() + i * bytesPerTexel(wide.format));
    });
    return wide;
}

int mipCount(int width, int height)
{
    return std::bit_width(static_cast<unsigned>(std::max(width, height)));
}

std::vector<TextureImage> makeMips(const TextureImage& base, const MipRule& rule)
{
    assert(base.width > 0 && base.height > 0);
    const Codec codec(base.format, rule);
    std::vector<TextureImage> levels;
    Means means;
    for (int level = 1; level < mipCount(base.width, base.height); ++level) {
        means = level == 1 ? reduceImage(base, codec) : reduceMeans(means);
        levels.push_back(storeMeans(means, codec, base.name));
    }
    return levels;
}

} // namespace torrance
