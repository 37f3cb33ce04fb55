#include "core/error.h"
#include "files/png_texels.h"
#include "files/texture_decoders.h"

#include <png.h>

#include <bit>
#include <cstdio>
#include <cstring>

namespace torrance {
namespace {

// Deflate cannot shrink more than about 1032 times (RFC 1951: 258 bytes from two bits). A file that claims more texels
// than its length can hold is refused before memory is taken for them.
constexpr unsigned long long kMaxDeflateRatio = 1040;

// Chunks that do not bear on the stored code values, and whose contents could only make reading fail or grow.
constexpr png_byte kIgnoredChunks[] =
    "gAMA\0cHRM\0iCCP\0sRGB\0iTXt\0zTXt\0tEXt\0eXIf\0hIST\0sPLT\0bKGD\0pCAL\0sCAL\0tIME";
constexpr int kIgnoredChunkCount = sizeof kIgnoredChunks / 5;

/// libpng reports errors with longjmp, which skips destructors: every function that it may leave this way holds trivial
/// locals only, and this object, with all that is to be released, lives in the caller.
struct PngReader
{
    png_structp png = nullptr;
    png_infop info = nullptr;
    const std::byte* next = nullptr;
    std::size_t left = 0;
    char problem[128] = "";

    explicit PngReader(std::span<const std::byte> bytes) : next(bytes.data()), left(bytes.size()) {}
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
};

[[noreturn]] void onError(png_structp png, png_const_charp message)
{
    auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
    std::snprintf(reader->problem, sizeof reader->problem, "%s", message);
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void onRead(png_structp png, png_bytep to, std::size_t count)
{
    auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
    if (count > reader->left)
        png_error(png, "the file ends too early");
    std::memcpy(to, reader->next, count);
    reader->next += count;
    reader->left -= count;
}

bool readHeader(PngReader& reader)
{
    reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, onError, onWarning);
    if (reader.png == nullptr)
        return false;
    if (setjmp(png_jmpbuf(reader.png)) != 0)
        return false;
    reader.info = png_create_info_struct(reader.png);
    png_set_read_fn(reader.png, &reader, onRead);
    png_set_user_limits(reader.png, 0x7fffffff, 0x7fffffff); // ours come with a better message
    png_set_keep_unknown_chunks(reader.png, PNG_HANDLE_CHUNK_NEVER, kIgnoredChunks, kIgnoredChunkCount);
    png_read_info(reader.png, reader.info);
    return true;
}

/// Whatever is stored becomes four channels of 8 bits, or of 16 where the file has 16.
bool setTransforms(PngReader& reader, bool sixteenBits)
{
    if (setjmp(png_jmpbuf(reader.png)) != 0)
        return false;
    png_set_expand(reader.png); // palette, 1 2 4 bits, tRNS
    png_set_gray_to_rgb(reader.png);
    png_set_add_alpha(reader.png, sixteenBits ? 0xffff : 0xff, PNG_FILLER_AFTER);
    if (sixteenBits && std::endian::native == std::endian::little)
        png_set_swap(reader.png);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return true;
}

bool readRows(PngReader& reader, png_bytepp rows)
{
    if (setjmp(png_jmpbuf(reader.png)) != 0)
        return false;
    png_read_image(reader.png, rows);
    png_read_end(reader.png, nullptr);
    return true;
}

void check(bool done, const PngReader& reader, const TextureSource& source)
{
    if (!done)
        throwCorrupt(source, std::string("the PNG is corrupt: ") + (*reader.problem ? reader.problem : "no memory"));
}

PngLayout layoutOf(const PngReader& reader)
{
    PngLayout layout = {.width = png_get_image_width(reader.png, reader.info),
                        .height = png_get_image_height(reader.png, reader.info),
                        .bitDepth = png_get_bit_depth(reader.png, reader.info),
                        .colorType = png_get_color_type(reader.png, reader.info),
                        .interlaced = png_get_interlace_type(reader.png, reader.info) != PNG_INTERLACE_NONE};
    png_colorp colors = nullptr;
    png_bytep alphas = nullptr;
    int colorCount = 0, alphaCount = 0;
    png_get_PLTE(reader.png, reader.info, &colors, &colorCount);
    png_get_tRNS(reader.png, reader.info, &alphas, &alphaCount, nullptr);
    layout.hasKeyColor = alphaCount > 0 && layout.colorType != PNG_COLOR_TYPE_PALETTE;
    for (int i = 0; i < 256; ++i) { // as libpng has it: what the file leaves out is black and opaque
        const png_color color = i < colorCount ? colors[i] : png_color{};
        const std::uint8_t rgba[] = {color.red, color.green, color.blue,
                                     !layout.hasKeyColor && i < alphaCount ? alphas[i] : std::uint8_t(255)};
        std::memcpy(&layout.palette[static_cast<std::size_t>(i)], rgba, sizeof rgba);
    }
    return layout;
}

/// Reads up to the texels: what they are, and none of them.
TextureImage readUpToTexels(PngReader& reader, std::size_t fileBytes, const TextureSource& source)
{
    check(readHeader(reader), reader, source);
    const png_uint_32 width = png_get_image_width(reader.png, reader.info);
    const png_uint_32 height = png_get_image_height(reader.png, reader.info);
    checkTextureSize(width, height, source);
    const unsigned long long storedBytes = png_get_rowbytes(reader.png, reader.info) * 1ull * height;
    if (storedBytes / kMaxDeflateRatio > fileBytes)
        throwCorrupt(source, "the PNG is corrupt: the file ends too early");
    return {.name = source.name,
            .width = static_cast<int>(width),
            .height = static_cast<int>(height),
            .format = png_get_bit_depth(reader.png, reader.info) == 16 ? TexelFormat::rgba16 : TexelFormat::rgba8,
            .texels = {}};
}

} // namespace

TextureImage decodePng(std::span<const std::byte> bytes, const TextureSource& source, DecodeScratch& scratch)
{
    PngReader reader(bytes);
    TextureImage image = readUpToTexels(reader, bytes.size(), source);
    const auto height = static_cast<std::size_t>(image.height);
    const std::size_t rowBytes = static_cast<std::size_t>(image.width) * bytesPerTexel(image.format);
    resizeLarge(image.texels, rowBytes * height);
    constexpr std::size_t kChunkHeader = 8; // of the first IDAT, which has been read
    if (readPngTexels(layoutOf(reader), {reader.next - kChunkHeader, reader.left + kChunkHeader}, scratch,
                      image.texels.data()))
        return image;

    check(setTransforms(reader, image.format == TexelFormat::rgba16), reader, source);
    if (png_get_rowbytes(reader.png, reader.info) != rowBytes)
        throwCorrupt(source, "the PNG has a layout of channels that is not known");
    std::vector<png_bytep> rows(height);
    for (std::size_t y = 0; y < rows.size(); ++y)
        rows[y] = reinterpret_cast<png_bytep>(image.texels.data() + y * rowBytes);
    check(readRows(reader, rows.data()), reader, source);
    return image;
}

std::optional<ImageSize> pngSize(std::span<const std::byte> bytes)
{
    // The first chunk is IHDR by definition: length, name, width and height, big-endian (PNG specification 11.2.2).
    constexpr std::size_t kWidthOffset = 16;
    if (bytes.size() < kWidthOffset + 8)
        return std::nullopt;
    const auto number = [&](std::size_t offset) {
        int value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value = value << 8 | std::to_integer<int>(bytes[offset + i] & (i == 0 ? std::byte(0x7f) : std::byte(0xff)));
        return value;
    };
    return ImageSize{number(kWidthOffset), number(kWidthOffset + 4)};
}

} // namespace torrance
