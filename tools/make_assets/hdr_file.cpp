#include "make_assets/hdr_file.h"

#include "core/atomic_write.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace torrance::assets {
namespace {

/// Three mantissas of eight bits under one exponent, rounded to nearest.
std::array<char, 4> rgbe(const float* rgb)
{
    const float largest = std::max({rgb[0], rgb[1], rgb[2]});
    if (largest < 1e-32f) // Ward's least value
        return {0, 0, 0, 0};
    int exponent = 0;
    std::frexp(largest, &exponent);
    if (std::lround(std::ldexp(largest, 8 - exponent)) > 255)
        ++exponent;
    std::array<char, 4> bytes{};
    for (std::size_t c = 0; c < 3; ++c)
        bytes[c] = static_cast<char>(std::lround(std::ldexp(rgb[c], 8 - exponent)));
    bytes[3] = static_cast<char>(exponent + 128);
    return bytes;
}

} // namespace

void writeHdr(const std::filesystem::path& path, const Image& image)
{
    std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(image.height) + " +X " +
                       std::to_string(image.width) + "\n";
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::array<char, 4> bytes = rgbe(image.at(x, y));
            text.append(bytes.data(), bytes.size());
        }
    writeFile(path, text);
}

} // namespace torrance::assets
