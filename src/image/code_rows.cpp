#include "image/code_rows.h"

#include "core/parallel.h"
#include "image/code_table.h"
#include "image/quantize.h"
#include "math/float4.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

namespace torrance {
namespace {

void quantizeRow(const float* values, std::size_t count, int bits, std::uint8_t* codes)
{
    if (bits == 8) {
        for (std::size_t i = 0; i < count; ++i)
            codes[i] = static_cast<std::uint8_t>(quantized(values[i], 255));
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint16_t code = quantized(values[i], 65535);
        codes[2 * i] = static_cast<std::uint8_t>(code >> 8);
        codes[2 * i + 1] = static_cast<std::uint8_t>(code & 0xff);
    }
}

/// The steps of the curve as it is computed in float, rounding and all: found by bisection of the floats between 0
/// and 1.
CodeSteps stepsOf(const TransferCurve& curve)
{
    CodeSteps from;
    for (std::size_t code = 0; code < from.size(); ++code) {
        std::uint32_t below = 0, atLeast = std::bit_cast<std::uint32_t>(1.0f);
        while (atLeast - below > 1) {
            const std::uint32_t middle = (below + atLeast) / 2;
            (quantized(curve.single(std::bit_cast<float>(middle)), 255) > code ? atLeast : below) = middle;
        }
        from[code] = std::bit_cast<float>(atLeast);
    }
    return from;
}

struct FourPixels
{
    Float4 red, green, blue, alpha;
};

FourPixels load(const float* texels, int channels, int count)
{
    Float4 pixels[4] = {};
    if (channels == 4 && count == 4)
        for (int i = 0; i < 4; ++i)
            pixels[i] = load4(texels + 4 * i);
    else
        for (int i = 0; i < count; ++i)
            for (int c = 0; c < channels; ++c)
                pixels[i][c] = texels[i * channels + c];
    transpose(pixels[0], pixels[1], pixels[2], pixels[3]);
    return {pixels[0], pixels[1], pixels[2], pixels[3]};
}

Float4 clippedToUnit(Float4 value) // a NaN too
{
    const Float4 nothing = splat(0.0f);
    return least(value > nothing ? value : nothing, splat(1.0f));
}

/// A row of 8-bit codes, four pixels at a time, as displayPixels() and quantized() give them one by one.
class DisplayRow
{
public:
    DisplayRow(const Image& image, const DisplaySettings& display)
        : picture(image), tone(display.tone->four), gain(splat(exposureGain(display))),
          codes(stepsOf(*display.transfer)), keepsAlpha(keepsCoverage(image, display))
    {
    }

    void operator()(int y, std::uint8_t* to) const
    {
        const float* from = picture.at(0, y);
        for (int x = 0; x < picture.width; x += 4) {
            const int count = std::min(4, picture.width - x);
            write(shown(load(from + x * picture.channels, picture.channels, count)), count, to);
            to += count * (keepsAlpha ? 4 : 3);
        }
    }

private:
    FourPixels shown(FourPixels p) const
    {
        const Float4 scale = keepsAlpha ? gain * coverageScale(p.alpha) : gain;
        p.red *= scale;
        p.green *= scale;
        p.blue *= scale;
        tone(p.red, p.green, p.blue);
        return p;
    }

    void write(const FourPixels& p, int count, std::uint8_t* to) const
    {
        const CodeTable::Lookup codeOf = codes.lookup();
        Int4 channels[] = {codeOf(clippedToUnit(p.red)), codeOf(clippedToUnit(p.green)), codeOf(clippedToUnit(p.blue)),
                           roundedProduct(clippedToUnit(p.alpha), 255.0)};
        transpose(channels[0], channels[1], channels[2], channels[3]);
        std::uint8_t four[16];
        pack(channels[0], channels[1], channels[2], channels[3], four);
        if (keepsAlpha && count == 4)
            std::memcpy(to, four, sizeof four);
        else
            for (int i = 0; i < count; ++i)
                to = std::copy_n(four + 4 * i, keepsAlpha ? 4 : 3, to);
    }

    const Image& picture;
    void (*tone)(Float4&, Float4&, Float4&);
    Float4 gain;
    CodeTable codes;
    bool keepsAlpha;
};

} // namespace

CodeRows quantizedRows(const Image& image, int bits)
{
    assert(bits == 8 || bits == 16);
    return {image.width, image.height, image.channels, bits, [&image, bits](int y, std::uint8_t* codes) {
                quantizeRow(image.at(0, y), static_cast<std::size_t>(image.width * image.channels), bits, codes);
            }};
}

CodeRows displayRows(const Image& sceneLinear, const DisplaySettings& settings, int bits)
{
    assert(bits == 8 || bits == 16);
    CodeRows rows = {sceneLinear.width, sceneLinear.height, keepsCoverage(sceneLinear, settings) ? 4 : 3, bits, {}};
    if (bits == 8)
        rows.row = DisplayRow(sceneLinear, settings);
    else
        rows.row = [&sceneLinear, settings, channels = rows.channels](int y, std::uint8_t* codes) {
            Image shown(sceneLinear.width, 1, channels);
            displayRow(sceneLinear, y, settings, shown.texels.data());
            quantizeRow(shown.texels.data(), shown.texels.size(), 16, codes);
        };
    return rows;
}

std::vector<std::uint8_t> allCodes(const CodeRows& rows)
{
    std::vector<std::uint8_t> codes(rows.rowBytes() * static_cast<std::size_t>(rows.height));
    parallelFor(static_cast<std::size_t>(rows.height), 16,
                [&](std::size_t y) { rows.row(static_cast<int>(y), codes.data() + y * rows.rowBytes()); });
    return codes;
}

} // namespace torrance
