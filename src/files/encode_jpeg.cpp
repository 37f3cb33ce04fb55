#include "core/error.h"
#include "files/image_encoders.h"

#include <turbojpeg.h>

#include <cassert>
#include <memory>
#include <new>

namespace torrance {
namespace {

constexpr int kMaxJpegSide = 65500; // libjpeg's JPEG_MAX_DIMENSION

} // namespace

std::vector<std::byte> encodeJpeg(const CodeRows& rows, int quality)
{
    assert(rows.bits == 8 && (rows.channels == 1 || rows.channels == 3));
    if (rows.width > kMaxJpegSide || rows.height > kMaxJpegSide)
        throw usageError("JPEG takes at most 65500 texels a side", "write PNG or EXR");
    const std::vector<std::uint8_t> codes = allCodes(rows);
    const bool grey = rows.channels == 1;
    const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), tjDestroy);
    unsigned char* data = nullptr;
    unsigned long size = 0;
    const int status =
        encoder ? tjCompress2(encoder.get(), codes.data(), rows.width, 0, rows.height, grey ? TJPF_GRAY : TJPF_RGB,
                              &data, &size, grey ? TJSAMP_GRAY : TJSAMP_444, quality, TJFLAG_ACCURATEDCT)
                : -1;
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owner(data, tjFree);
    if (status != 0)
        throw std::bad_alloc(); // size and quality are checked: memory is what is left
    const auto* bytes = reinterpret_cast<const std::byte*>(data);
    return {bytes, bytes + size};
}

} // namespace torrance
