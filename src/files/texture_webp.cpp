#include "core/error.h"
#include "core/huge_pages.h"
#include "files/texture_decoders.h"

#include <webp/decode.h>

namespace torrance {
namespace {

const std::uint8_t* data(std::span<const std::byte> bytes)
{
    return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

} // namespace

TextureImage decodeWebp(std::span<const std::byte> bytes, const TextureSource& source)
{
    WebPBitstreamFeatures features = {};
    if (WebPGetFeatures(data(bytes), bytes.size(), &features) != VP8_STATUS_OK)
        throwCorrupt(source, "the WebP is corrupt: no readable header");
    checkTextureSize(features.width, features.height, source);
    if (features.has_animation != 0)
        throw inputError(source.file, source.name, "the WebP is an animation", "store one picture");

    TextureImage image{.name = source.name, .width = features.width, .height = features.height, .texels = {}};
    const std::size_t rowBytes = static_cast<std::size_t>(features.width) * bytesPerTexel(image.format);
    resizeLarge(image.texels, rowBytes * static_cast<std::size_t>(features.height));
    // Straight alpha, one where the file has none.
    if (WebPDecodeRGBAInto(data(bytes), bytes.size(), reinterpret_cast<std::uint8_t*>(image.texels.data()),
                           image.texels.size(), static_cast<int>(rowBytes)) == nullptr)
        throwCorrupt(source, "the WebP is corrupt or ends too early");
    return image;
}

std::optional<ImageSize> webpSize(std::span<const std::byte> bytes)
{
    ImageSize size;
    if (WebPGetInfo(data(bytes), bytes.size(), &size.width, &size.height) == 0)
        return std::nullopt;
    return size;
}

} // namespace torrance
