#include "files/hdr_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace torrance {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

// 255/256 * 2^127, the largest mantissa under the largest exponent.
constexpr double kMaxRadiance = 0x1.fep126;
// A line in the new coding names its length in 15 bits, and shorter ones could be taken for texels.
constexpr int kMinRunLine = 8, kMaxRunLine = 32767;
constexpr std::size_t kMaxRun = 127, kMaxLiteral = 128;
// A run costs two bytes, and interrupting a literal two more.
constexpr std::size_t kMinRun = 4;

double admitted(float value)
{
    return value > 0.0f ? std::min(static_cast<double>(value), kMaxRadiance) : 0.0;
}

Rgbe rgbeOf(const Image& image, int x, int y)
{
    std::array<double, 3> color;
    for (int channel = 0; channel < 3; ++channel)
        color[static_cast<std::size_t>(channel)] = admitted(image.at(x, y)[image.channels < 3 ? 0 : channel]);
    const double largest = std::max({color[0], color[1], color[2]});
    int exponent = 0;
    std::frexp(largest, &exponent);                                // largest = [0.5, 1) * 2^exponent
    if (std::nearbyint(std::ldexp(largest, 8 - exponent)) > 255.0) // rounds up to the next power of two
        ++exponent;
    if (largest == 0.0 || exponent + 128 < 1)
        return {0, 0, 0, 0};
    Rgbe texel;
    for (std::size_t channel = 0; channel < 3; ++channel)
        texel[channel] = static_cast<std::uint8_t>(std::nearbyint(std::ldexp(color[channel], 8 - exponent)));
    texel[3] = static_cast<std::uint8_t>(exponent + 128);
    return texel;
}

std::size_t runLength(const std::vector<std::uint8_t>& values, std::size_t from)
{
    std::size_t end = from + 1;
    while (end < values.size() && end - from < kMaxRun && values[end] == values[from])
        ++end;
    return end - from;
}

void appendRuns(std::string& bytes, const std::vector<std::uint8_t>& values)
{
    for (std::size_t x = 0; x < values.size();) {
        if (const std::size_t run = runLength(values, x); run >= kMinRun) {
            bytes.push_back(static_cast<char>(128 + run));
            bytes.push_back(static_cast<char>(values[x]));
            x += run;
            continue;
        }
        std::size_t end = x + 1;
        while (end < values.size() && end - x < kMaxLiteral && runLength(values, end) < kMinRun)
            ++end;
        bytes.push_back(static_cast<char>(end - x));
        bytes.append(values.begin() + static_cast<std::ptrdiff_t>(x),
                     values.begin() + static_cast<std::ptrdiff_t>(end));
        x = end;
    }
}

void appendLine(std::string& bytes, const std::vector<Rgbe>& line)
{
    const auto width = static_cast<int>(line.size());
    if (width < kMinRunLine || width > kMaxRunLine) {
        for (const Rgbe& texel : line)
            bytes.append(texel.begin(), texel.end());
        return;
    }
    for (const int value : {2, 2, width >> 8, width & 0xff})
        bytes.push_back(static_cast<char>(value));
    std::vector<std::uint8_t> values(line.size());
    for (std::size_t channel = 0; channel < 4; ++channel) {
        std::transform(line.begin(), line.end(), values.begin(), [=](const Rgbe& texel) { return texel[channel]; });
        appendRuns(bytes, values);
    }
}

} // namespace

std::vector<std::byte> encodeHdr(const Image& image)
{
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(image.height) + " +X " +
                        std::to_string(image.width) + "\n";
    std::vector<Rgbe> line(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x)
            line[static_cast<std::size_t>(x)] = rgbeOf(image, x, y);
        appendLine(bytes, line);
    }
    const auto view = std::as_bytes(std::span(bytes));
    return {view.begin(), view.end()};
}

} // namespace torrance
