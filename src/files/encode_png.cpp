#include "core/parallel.h"
#include "files/image_encoders.h"
#include "files/png_filters.h"

#include <libdeflate.h>
#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <new>
#include <string_view>

namespace torrance {
namespace {

// Rows are packed in stripes that know nothing of each other, of a size that depends on the picture alone: so do the
// bytes.
constexpr std::size_t kStripeBytes = 1u << 17;

void append(std::vector<std::byte>& bytes, std::span<const std::byte> more)
{
    bytes.insert(bytes.end(), more.begin(), more.end());
}

void append(std::vector<std::byte>& bytes, std::uint32_t bigEndian)
{
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<std::byte>(bigEndian >> shift));
}

void appendChunk(std::vector<std::byte>& file, std::string_view name, std::span<const std::byte> data)
{
    append(file, static_cast<std::uint32_t>(data.size()));
    const std::size_t begin = file.size();
    append(file, std::as_bytes(std::span(name)));
    append(file, data);
    append(file, libdeflate_crc32(0, file.data() + begin, file.size() - begin));
}

/// Part of the stream: packed, whole bytes, and what the Adler-32 of the whole is made from.
struct Stripe
{
    std::vector<std::byte> packed;
    std::size_t rawBytes = 0;
    std::uint32_t adler = 1;
};

struct Deflate
{
    z_stream stream = {};

    Deflate()
    {
        // Runs of one byte alone are looked for: differences of rendered pictures are zeros and noise, and what a
        // search for longer matches gains there is less than what its codes for distances cost.
        constexpr int kRawWindow = -15, kMemory = 9;
        if (deflateInit2(&stream, 1, Z_DEFLATED, kRawWindow, kMemory, Z_RLE) != Z_OK)
            throw std::bad_alloc();
    }
    ~Deflate() { deflateEnd(&stream); }
    Deflate(const Deflate&) = delete;
    Deflate& operator=(const Deflate&) = delete;
};

/// Ended by an empty block that goes to the end of its byte, so that another stripe can follow, or as the stream's
/// last.
std::vector<std::byte> packedOf(std::span<const std::byte> raw, bool isLast)
{
    Deflate deflate;
    z_stream& stream = deflate.stream;
    constexpr std::size_t kEmptyBlock = 6;
    std::vector<std::byte> packed(deflateBound(&stream, raw.size()) + kEmptyBlock);
    stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(raw.data()));
    stream.avail_in = static_cast<uInt>(raw.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    [[maybe_unused]] const int status = ::deflate(&stream, isLast ? Z_FINISH : Z_SYNC_FLUSH);
    assert(status == (isLast ? Z_STREAM_END : Z_OK) && stream.avail_in == 0);
    packed.resize(stream.total_out);
    return packed;
}

/// Rows [first, end) as their differences to what Paeth's predictor makes of their neighbours: of all filters the one
/// that leaves least of rendered pictures, nearly always.
Stripe makeStripe(const CodeRows& rows, int first, int end)
{
    const std::size_t rowBytes = rows.rowBytes();
    std::vector<std::uint8_t> above(rowBytes), row(rowBytes);
    if (first > 0)
        rows.row(first - 1, above.data());
    std::vector<std::byte> filtered((rowBytes + 1) * static_cast<std::size_t>(end - first));
    std::byte* to = filtered.data();
    for (int y = first; y < end; ++y, to += rowBytes + 1) {
        rows.row(y, row.data());
        *to = static_cast<std::byte>(PngFilter::paeth);
        filterByPaeth(row.data(), above.data(), rowBytes, static_cast<std::size_t>(rows.channels * rows.bits / 8),
                      to + 1);
        std::swap(row, above);
    }
    return {.packed = packedOf(filtered, end == rows.height),
            .rawBytes = filtered.size(),
            .adler = libdeflate_adler32(1, filtered.data(), filtered.size())};
}

std::vector<std::byte> headerOf(const CodeRows& rows)
{
    constexpr std::uint8_t kColorTypes[] = {0, 0, 0, 2, 6}; // by channels
    std::vector<std::byte> header;
    append(header, static_cast<std::uint32_t>(rows.width));
    append(header, static_cast<std::uint32_t>(rows.height));
    for (const int value : {rows.bits, static_cast<int>(kColorTypes[rows.channels]), 0, 0, 0})
        header.push_back(static_cast<std::byte>(value));
    return header;
}

} // namespace

std::vector<std::byte> encodePng(const CodeRows& rows)
{
    assert(rows.channels == 1 || rows.channels == 3 || rows.channels == 4);
    assert(rows.bits == 8 || rows.bits == 16);
    const std::size_t rowsEach = std::max<std::size_t>(1, kStripeBytes / (rows.rowBytes() + 1));
    const auto height = static_cast<std::size_t>(rows.height);
    std::vector<Stripe> stripes((height + rowsEach - 1) / rowsEach);
    parallelFor(stripes.size(), 1, [&](std::size_t i) {
        stripes[i] =
            makeStripe(rows, static_cast<int>(i * rowsEach), static_cast<int>(std::min((i + 1) * rowsEach, height)));
    });

    constexpr std::byte kZlibHeader[] = {std::byte(0x78), std::byte(0x01)}; // a window of 32 KiB, quickly packed
    constexpr std::byte kPerceptual[] = {std::byte(0)};
    std::vector<std::byte> file;
    append(file, std::as_bytes(std::span("\x89PNG\r\n\x1a\n", 8)));
    appendChunk(file, "IHDR", headerOf(rows));
    appendChunk(file, "sRGB", kPerceptual);
    appendChunk(file, "IDAT", kZlibHeader);
    uLong adler = 1;
    for (const Stripe& stripe : stripes) {
        appendChunk(file, "IDAT", stripe.packed);
        adler = adler32_combine(adler, stripe.adler, static_cast<z_off_t>(stripe.rawBytes));
    }
    std::vector<std::byte> trailer;
    append(trailer, static_cast<std::uint32_t>(adler));
    appendChunk(file, "IDAT", trailer);
    appendChunk(file, "IEND", {});
    return file;
}

std::vector<std::byte> encodePng(const Image& image, int bitsPerChannel)
{
    return encodePng(quantizedRows(image, bitsPerChannel));
}

} // namespace torrance
