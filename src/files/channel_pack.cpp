#include "files/channel_pack.h"

#include "core/parallel.h"
#include "image/srgb.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace torrance {
namespace {

constexpr double kMost8 = 255.0, kMost16 = 65535.0;

std::size_t offsetOf(const TextureImage& image, int x, int y)
{
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
           bytesPerTexel(image.format);
}

std::array<std::uint16_t, 4> codesAt(const TextureImage& image, std::size_t offset)
{
    std::array<std::uint16_t, 4> codes = {};
    if (image.format == TexelFormat::rgba16)
        std::memcpy(codes.data(), image.texels.data() + offset, sizeof codes);
    else
        for (std::size_t c = 0; c < 4; ++c)
            codes[c] = std::to_integer<std::uint16_t>(image.texels[offset + c]);
    return codes;
}

double most(const TextureImage& image)
{
    return image.format == TexelFormat::rgba8 ? kMost8 : kMost16;
}

template <typename Test>
bool anyTexel(const TextureImage& image, Test&& test)
{
    for (std::size_t offset = 0; offset < image.texels.size(); offset += bytesPerTexel(image.format))
        if (test(codesAt(image, offset)))
            return true;
    return false;
}

int wrapped(int i, int size, Wrap wrap)
{
    return wrap == Wrap::clampToEdge ? std::clamp(i, 0, size - 1) : ((i % size) + size) % size;
}

double linearValue(const PackedChannel& source, int x, int y)
{
    const double value = texelValue(*source.image, x, y, source.channel);
    return source.srgb ? srgbDecode(value) : value;
}

/// At the middle of texel (x, y) of a picture of this size.
double enlarged(const PackedChannel& source, int x, int y, int width, int height, Wrap wrap)
{
    const TextureImage& image = *source.image;
    const double u = (x + 0.5) * image.width / width - 0.5;
    const double v = (y + 0.5) * image.height / height - 0.5;
    const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
    const double s = u - left, t = v - top;
    const int x0 = wrapped(left, image.width, wrap), x1 = wrapped(left + 1, image.width, wrap);
    const int y0 = wrapped(top, image.height, wrap), y1 = wrapped(top + 1, image.height, wrap);
    const double above = linearValue(source, x0, y0) * (1.0 - s) + linearValue(source, x1, y0) * s;
    const double below = linearValue(source, x0, y1) * (1.0 - s) + linearValue(source, x1, y1) * s;
    const double value = above * (1.0 - t) + below * t;
    return source.srgb ? srgbEncode(value) : value;
}

bool hasSize(const TextureImage& image, int width, int height)
{
    return image.width == width && image.height == height;
}

double valueOf(const PackedChannel& source, int x, int y, const TextureImage& target, Wrap wrap)
{
    if (source.image == nullptr)
        return source.constant;
    const double value = hasSize(*source.image, target.width, target.height)
                             ? texelValue(*source.image, x, y, source.channel)
                             : enlarged(source, x, y, target.width, target.height, wrap);
    const double turned = source.inverted ? 1.0 - value : value;
    return source.change ? source.change(turned) : turned;
}

} // namespace

double texelValue(const TextureImage& image, int x, int y, Channel channel)
{
    const std::array<std::uint16_t, 4> codes = codesAt(image, offsetOf(image, x, y));
    if (channel == Channel::luminance && (codes[0] != codes[1] || codes[1] != codes[2]))
        return (0.2126 * codes[0] + 0.7152 * codes[1] + 0.0722 * codes[2]) / most(image);
    return codes[channel == Channel::luminance ? 0 : static_cast<std::size_t>(channel)] / most(image);
}

void storeTexel(TextureImage& image, int x, int y, const std::array<double, 4>& values)
{
    const std::size_t offset = offsetOf(image, x, y);
    for (std::size_t c = 0; c < 4; ++c) {
        const auto code = static_cast<std::uint16_t>(std::lround(std::clamp(values[c], 0.0, 1.0) * most(image)));
        if (image.format == TexelFormat::rgba16)
            std::memcpy(image.texels.data() + offset + c * sizeof code, &code, sizeof code);
        else
            image.texels[offset + c] = static_cast<std::byte>(code);
    }
}

bool hasAlpha(const TextureImage& image)
{
    return anyTexel(image, [&](const auto& codes) { return codes[3] != most(image); });
}

bool isGrey(const TextureImage& image)
{
    return !anyTexel(image, [](const auto& codes) { return codes[0] != codes[1] || codes[1] != codes[2]; });
}

TextureImage packChannels(const std::string& name, const std::array<PackedChannel, 4>& channels, Wrap wrap)
{
    TextureImage packed;
    packed.name = name;
    packed.width = packed.height = 1;
    for (const PackedChannel& source : channels)
        if (source.image != nullptr) {
            packed.width = std::max(packed.width, source.image->width);
            packed.height = std::max(packed.height, source.image->height);
        }
    for (const PackedChannel& source : channels)
        if (source.image != nullptr && (source.image->format == TexelFormat::rgba16 || source.change ||
                                        !hasSize(*source.image, packed.width, packed.height)))
            packed.format = TexelFormat::rgba16;
    packed.texels.resize(static_cast<std::size_t>(packed.width) * static_cast<std::size_t>(packed.height) *
                         bytesPerTexel(packed.format));
    parallelFor(static_cast<std::size_t>(packed.height), 16, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < packed.width; ++x) {
            std::array<double, 4> values;
            for (std::size_t c = 0; c < 4; ++c)
                values[c] = valueOf(channels[c], x, y, packed, wrap);
            storeTexel(packed, x, y, values);
        }
    });
    return packed;
}

} // namespace torrance
