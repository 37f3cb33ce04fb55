#include "core/error.h"
#include "files/image_codes.h"
#include "files/image_encoders.h"

#include <webp/encode.h>

#include <cassert>
#include <memory>
#include <new>

namespace torrance {

std::vector<std::byte> encodeWebp(const Image& image, int quality)
{
    assert(image.channels == 3 || image.channels == 4);
    if (image.width > WEBP_MAX_DIMENSION || image.height > WEBP_MAX_DIMENSION)
        throw usageError("WebP takes at most 16383 texels a side", "write PNG or EXR");
    const std::vector<std::uint8_t> codes = codes8(image);
    const int stride = image.width * image.channels;
    std::uint8_t* data = nullptr;
    std::size_t size = 0;
    if (quality == 100)
        size = image.channels == 4 ? WebPEncodeLosslessRGBA(codes.data(), image.width, image.height, stride, &data)
                                   : WebPEncodeLosslessRGB(codes.data(), image.width, image.height, stride, &data);
    else {
        const auto factor = static_cast<float>(quality);
        size = image.channels == 4 ? WebPEncodeRGBA(codes.data(), image.width, image.height, stride, factor, &data)
                                   : WebPEncodeRGB(codes.data(), image.width, image.height, stride, factor, &data);
    }
    const std::unique_ptr<std::uint8_t, void (*)(void*)> owner(data, WebPFree);
    if (size == 0)
        throw std::bad_alloc(); // size and quality are checked: memory is what is left
    const auto* bytes = reinterpret_cast<const std::byte*>(data);
    return {bytes, bytes + size};
}

} // namespace torrance
