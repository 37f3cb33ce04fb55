#include "core/error.h"
#include "core/huge_pages.h"
#include "core/log.h"
#include "files/texture_decoders.h"

#include <memory>
#include <string_view>
#include <turbojpeg.h>

namespace torrance {
namespace {

struct Header
{
    int width = 0;
    int height = 0;
    int subsampling = 0;
    int colorSpace = 0;
};

using Decoder = std::unique_ptr<void, int (*)(tjhandle)>;

Decoder makeDecoder()
{
    return {tjInitDecompress(), tjDestroy};
}

const unsigned char* data(std::span<const std::byte> bytes)
{
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

bool readHeader(const Decoder& decoder, std::span<const std::byte> bytes, Header& header)
{
    return decoder && tjDecompressHeader3(decoder.get(), data(bytes), bytes.size(), &header.width, &header.height,
                                          &header.subsampling, &header.colorSpace) == 0;
}

// A few bytes between two segments are left behind by some encoders and cost nothing; every other warning of libjpeg
// means that texels were made up.
bool isHarmless(std::string_view warning)
{
    return warning.find("extraneous bytes") != std::string_view::npos;
}

} // namespace

TextureImage decodeJpeg(std::span<const std::byte> bytes, const TextureSource& source)
{
    const Decoder decoder = makeDecoder();
    Header header;
    if (!readHeader(decoder, bytes, header))
        throwCorrupt(source, std::string("the JPEG is corrupt: ") + tjGetErrorStr2(decoder.get()));
    checkTextureSize(header.width, header.height, source);
    if (header.colorSpace == TJCS_CMYK || header.colorSpace == TJCS_YCCK)
        throw inputError(source.file, source.name, "the JPEG has CMYK colours", "convert it to RGB");

    TextureImage image{.name = source.name, .width = header.width, .height = header.height, .texels = {}};
    const std::size_t rowBytes = static_cast<std::size_t>(header.width) * bytesPerTexel(image.format);
    resizeLarge(image.texels, rowBytes * static_cast<std::size_t>(header.height));
    // LIMITSCANS: a progressive file of many empty scans would take for ever.
    const int status =
        tjDecompress2(decoder.get(), data(bytes), bytes.size(), reinterpret_cast<unsigned char*>(image.texels.data()),
                      header.width, static_cast<int>(rowBytes), header.height, TJPF_RGBA, TJFLAG_LIMITSCANS);
    if (status == 0)
        return image;
    const std::string problem = tjGetErrorStr2(decoder.get());
    if (tjGetErrorCode(decoder.get()) != TJERR_WARNING || !isHarmless(problem))
        throwCorrupt(source, "the JPEG is corrupt: " + problem);
    logWarning(source.file + ": " + source.name + ": " + problem);
    return image;
}

std::optional<ImageSize> jpegSize(std::span<const std::byte> bytes)
{
    const Decoder decoder = makeDecoder();
    Header header;
    if (!readHeader(decoder, bytes, header))
        return std::nullopt;
    return ImageSize{header.width, header.height};
}

} // namespace torrance
