#include "core/error.h"
#include "files/image_encoders.h"

#include <webp/encode.h>

#include <cassert>
#include <memory>
#include <new>

namespace torrance {

std::vector<std::byte> encodeWebp(const CodeRows& rows, int quality)
{
    assert(rows.bits == 8 && (rows.channels == 3 || rows.channels == 4));
    if (rows.width > WEBP_MAX_DIMENSION || rows.height > WEBP_MAX_DIMENSION)
        throw usageError("WebP takes at most 16383 texels a side", "write PNG or EXR");
    const std::vector<std::uint8_t> codes = allCodes(rows);
    const int stride = rows.width * rows.channels;
    std::uint8_t* data = nullptr;
    std::size_t size = 0;
    if (quality == 100)
        size = rows.channels == 4 ? WebPEncodeLosslessRGBA(codes.data(), rows.width, rows.height, stride, &data)
                                  : WebPEncodeLosslessRGB(codes.data(), rows.width, rows.height, stride, &data);
    else {
        const auto factor = static_cast<float>(quality);
        size = rows.channels == 4 ? WebPEncodeRGBA(codes.data(), rows.width, rows.height, stride, factor, &data)
                                  : WebPEncodeRGB(codes.data(), rows.width, rows.height, stride, factor, &data);
    }
    const std::unique_ptr<std::uint8_t, void (*)(void*)> owner(data, WebPFree);
    if (size == 0)
        throw std::bad_alloc(); // size and quality are checked: memory is what is left
    const auto* bytes = reinterpret_cast<const std::byte*>(data);
    return {bytes, bytes + size};
}

} // namespace torrance
