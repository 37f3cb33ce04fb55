#include "files/image_read.h"

#include "core/error.h"
#include "core/log.h"
#include "core/read_file.h"
#include "files/exr_file.h"
#include "files/hdr_file.h"
#include "files/openimageio_loader.h"
#include "files/texture_file.h"
#include "image/quantize.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <string_view>

namespace torrance {
namespace {

constexpr std::array<std::string_view, 4> kColorNames = {"R", "G", "B", "A"};

ReadImage fromHdr(std::span<const std::byte> bytes, const std::string& path)
{
    return {.image = decodeHdr(bytes, path), .displayReferred = false, .channelNames = {"R", "G", "B"}};
}

Image reordered(const Image& image, const std::vector<std::size_t>& order)
{
    Image result(image.width, image.height, image.channels);
    for (std::size_t texel = 0; texel < image.texels.size(); texel += order.size())
        for (std::size_t channel = 0; channel < order.size(); ++channel)
            result.texels[texel + channel] = image.texels[texel + order[channel]];
    return result;
}

ReadImage fromExr(std::span<const std::byte> bytes, const std::string& path)
{
    const ExrImage exr = decodeExr(bytes, path);
    if (exr.parts > 1)
        logWarning(path + ": has " + std::to_string(exr.parts) + " parts; the first is read");
    const auto rank = [&](std::size_t channel) {
        const auto place = std::find(kColorNames.begin(), kColorNames.end(), exr.channelNames[channel]);
        return place - kColorNames.begin();
    };
    std::vector<std::size_t> order(exr.channelNames.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    ReadImage result{.image = reordered(exr.image, order), .displayReferred = false, .channelNames = {}};
    for (const std::size_t channel : order)
        result.channelNames.push_back(exr.channelNames[channel]);
    return result;
}

float valueOf(const TextureImage& texture, std::size_t index)
{
    if (texture.format == TexelFormat::rgba8)
        return dequantized(std::to_integer<std::uint16_t>(texture.texels[index]), 255);
    std::uint16_t code = 0;
    std::memcpy(&code, texture.texels.data() + index * sizeof code, sizeof code);
    return dequantized(code, 65535);
}

ReadImage fromTexture(std::span<const std::byte> bytes, const std::string& path)
{
    const TextureImage texture = decodeTexture(bytes, "", path);
    ReadImage result{.image = Image(texture.width, texture.height, 4),
                     .displayReferred = true,
                     .channelNames = {kColorNames.begin(), kColorNames.end()}};
    for (std::size_t i = 0; i < result.image.texels.size(); ++i)
        result.image.texels[i] = valueOf(texture, i);
    return result;
}

// Other libraries would report the damage in their own words, and on standard error at that.
bool claimsOwnFormat(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    constexpr std::string_view kOwn[] = {".png", ".jpg", ".jpeg", ".webp", ".hdr", ".exr"};
    return std::find(std::begin(kOwn), std::end(kOwn), extension) != std::end(kOwn);
}

} // namespace

ReadImage readImage(const std::string& path)
{
    const std::vector<std::byte> bytes = readFile(path);
    if (isHdr(bytes))
        return fromHdr(bytes, path);
    if (isExr(bytes))
        return fromExr(bytes, path);
    if (isTexture(bytes))
        return fromTexture(bytes, path);
    if (claimsOwnFormat(path))
        throw inputError(path, "", "is not what its name says: neither PNG, JPEG, WebP, HDR nor EXR",
                         "get the file again, or correct its name");
    return readThroughOpenImageIo(path);
}

Image colorOf(ReadImage picture, const std::string& path)
{
    const auto& names = picture.channelNames;
    const auto isColor = [&](std::size_t i) { return i < names.size() && names[i] == kColorNames[i]; };
    const bool colored = isColor(0) && isColor(1) && isColor(2);
    if (!colored && names.size() != 1)
        throw inputError(path, "", "the picture has no channels R, G and B", "write them, or a single channel");
    if (colored && names.size() == 3)
        return std::move(picture.image);
    Image color(picture.image.width, picture.image.height, 3);
    const std::size_t stride = names.size();
    for (std::size_t texel = 0; texel < color.texels.size() / 3; ++texel)
        for (std::size_t channel = 0; channel < 3; ++channel)
            color.texels[texel * 3 + channel] = picture.image.texels[texel * stride + (colored ? channel : 0)];
    return color;
}

} // namespace torrance
