#include "files/image_codes.h"
#include "files/image_encoders.h"

#include <png.h>

#include <cassert>
#include <new>

namespace torrance {
namespace {

// Fixed, so that the bytes are. Rendered pictures are smooth: the difference to the left neighbour and a quick match
// search give most of what the slowest setting gives, at a fraction of its time.
constexpr int kZlibLevel = 4;
constexpr int kFilters = PNG_FILTER_SUB;

/// libpng leaves by longjmp, which skips destructors: all that needs one lives in the caller.
struct PngWriter
{
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<std::byte> bytes;

    PngWriter() = default;
    ~PngWriter() { png_destroy_write_struct(&png, &info); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
};

void onWrite(png_structp png, png_bytep data, std::size_t count)
{
    bool kept = true;
    try {
        auto& bytes = static_cast<PngWriter*>(png_get_io_ptr(png))->bytes;
        const auto* from = reinterpret_cast<const std::byte*>(data);
        bytes.insert(bytes.end(), from, from + count);
    } catch (const std::bad_alloc&) {
        kept = false;
    }
    if (!kept)
        png_error(png, "no memory");
}

void onFlush(png_structp) {}

[[noreturn]] void onError(png_structp png, png_const_charp)
{
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

int colorTypeOf(int channels)
{
    return channels == 1 ? PNG_COLOR_TYPE_GRAY : channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA;
}

/// False where memory ran out: the only error there can be.
bool write(PngWriter& writer, const Image& image, int bits, png_bytepp rows)
{
    writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer, onError, onWarning);
    if (writer.png == nullptr)
        return false;
    if (setjmp(png_jmpbuf(writer.png)) != 0)
        return false;
    writer.info = png_create_info_struct(writer.png);
    png_set_write_fn(writer.png, &writer, onWrite, onFlush);
    png_set_user_limits(writer.png, 0x7fffffff, 0x7fffffff);
    png_set_compression_level(writer.png, kZlibLevel);
    png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, kFilters);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
                 bits, colorTypeOf(image.channels), PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(writer.png, writer.info);
    png_write_image(writer.png, rows);
    png_write_end(writer.png, nullptr);
    return true;
}

} // namespace

std::vector<std::byte> encodePng(const Image& image, int bitsPerChannel)
{
    assert(image.channels == 1 || image.channels == 3 || image.channels == 4);
    assert(bitsPerChannel == 8 || bitsPerChannel == 16);
    std::vector<std::uint8_t> codes = bitsPerChannel == 8 ? codes8(image) : codes16(image);
    const std::size_t rowBytes = codes.size() / static_cast<std::size_t>(image.height);
    std::vector<png_bytep> rows(static_cast<std::size_t>(image.height));
    for (std::size_t y = 0; y < rows.size(); ++y)
        rows[y] = codes.data() + y * rowBytes;
    PngWriter writer;
    if (!write(writer, image, bitsPerChannel, rows.data()))
        throw std::bad_alloc();
    return std::move(writer.bytes);
}

} // namespace torrance
