#include "files/png_texels.h"

#include "files/png_filters.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <libdeflate.h>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace torrance {
namespace {

using namespace std::string_view_literals;

// Chunks behind the texels that libpng is told to skip, whatever is in them.
constexpr std::string_view kWithoutEffect[] = {"tEXt"sv, "zTXt"sv, "iTXt"sv, "tIME"sv, "eXIf"sv};

std::uint32_t bigEndian(const std::byte* at)
{
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i)
        value = value << 8 | std::to_integer<std::uint32_t>(at[i]);
    return value;
}

struct Chunk
{
    std::string_view name;
    std::span<const std::byte> data;
};

/// The chunk at the front, taken off; nothing where it is damaged.
std::optional<Chunk> takeChunk(std::span<const std::byte>& bytes)
{
    constexpr std::size_t kAround = 12; // length, name and CRC
    if (bytes.size() < kAround)
        return std::nullopt;
    const std::size_t length = bigEndian(bytes.data());
    if (length > bytes.size() - kAround)
        return std::nullopt;
    const Chunk chunk{{reinterpret_cast<const char*>(bytes.data()) + 4, 4}, bytes.subspan(8, length)};
    if (libdeflate_crc32(0, bytes.data() + 4, length + 4) != bigEndian(bytes.data() + 8 + length))
        return std::nullopt;
    bytes = bytes.subspan(kAround + length);
    return chunk;
}

/// The stream of all IDAT chunks, which are followed by nothing of effect and IEND; empty where they are not. Put
/// together in `room` where there are several.
std::span<const std::byte> takeStream(std::span<const std::byte> bytes, ReusedBytes& room)
{
    const std::size_t most = bytes.size();
    std::span<const std::byte> stream;
    std::byte* together = nullptr;
    for (bool inside = true;;) {
        const auto chunk = takeChunk(bytes);
        if (!chunk)
            return {};
        if (chunk->name == "IDAT" && inside) {
            if (stream.empty())
                stream = chunk->data;
            else {
                if (!together) {
                    together = room.atLeast(most);
                    std::copy(stream.begin(), stream.end(), together);
                }
                std::copy(chunk->data.begin(), chunk->data.end(), together + stream.size());
                stream = {together, stream.size() + chunk->data.size()};
            }
            continue;
        }
        inside = false;
        if (chunk->name == "IEND" && chunk->data.empty())
            return stream;
        if (std::ranges::find(kWithoutEffect, chunk->name) == std::end(kWithoutEffect))
            return {};
    }
}

/// zlib refuses distances beyond the window that the header claims, libdeflate does not look at it.
bool reachesBack(std::span<const std::byte> stream, std::size_t size)
{
    constexpr std::size_t kWindow = 32768; // what distances can express
    const int claimed = std::to_integer<int>(stream[0]) >> 4;
    return claimed <= 7 && std::size_t(256) << claimed >= std::min(size, kWindow);
}

bool inflateWhole(std::span<const std::byte> stream, std::byte* to, std::size_t size)
{
    struct Release
    {
        void operator()(libdeflate_decompressor* d) const { libdeflate_free_decompressor(d); }
    };
    const std::unique_ptr<libdeflate_decompressor, Release> decompressor(libdeflate_alloc_decompressor());
    std::size_t taken = 0;
    return decompressor && !stream.empty() && reachesBack(stream, size) &&
           libdeflate_zlib_decompress_ex(decompressor.get(), stream.data(), stream.size(), to, size, &taken, nullptr) ==
               LIBDEFLATE_SUCCESS &&
           taken == stream.size();
}

std::size_t channelsOf(int colorType)
{
    constexpr std::size_t kChannels[] = {1, 0, 3, 1, 2, 0, 4};
    return kChannels[colorType];
}

std::size_t pixelBytesOf(const PngLayout& layout)
{
    return channelsOf(layout.colorType) * static_cast<std::size_t>(layout.bitDepth) / 8;
}

/// Undone rows of other pictures than 8-bit RGB and RGBA, as four channels. Where each comes from, -1 for opaque.
template <std::size_t kBytes>
void spread(const std::byte* row, std::size_t pixels, int colorType, std::byte* texels)
{
    constexpr int kFrom[7][4] = {{0, 0, 0, -1}, {}, {0, 1, 2, -1}, {}, {0, 0, 0, 1}, {}, {0, 1, 2, 3}};
    const std::size_t pixelBytes = channelsOf(colorType) * kBytes;
    for (std::size_t i = 0; i < pixels; ++i, row += pixelBytes)
        for (const int from : kFrom[colorType]) {
            std::byte value[kBytes];
            std::fill_n(value, kBytes, std::byte(255));
            if (from >= 0)
                std::memcpy(value, row + static_cast<std::size_t>(from) * kBytes, kBytes);
            if (kBytes == 2 && std::endian::native == std::endian::little)
                std::swap(value[0], value[kBytes - 1]);
            std::memcpy(texels, value, kBytes);
            texels += kBytes;
        }
}

void lookUp(const std::byte* row, std::size_t pixels, const std::array<std::uint32_t, 256>& palette, std::byte* texels)
{
    for (std::size_t i = 0; i < pixels; ++i)
        std::memcpy(texels + 4 * i, &palette[std::to_integer<std::size_t>(row[i])], 4);
}

bool isKnown(const PngLayout& layout)
{
    return !layout.interlaced && !layout.hasKeyColor &&
           (layout.bitDepth == 8 || (layout.bitDepth == 16 && layout.colorType != 3));
}

/// Row for row; false at a filter that does not exist.
bool undoFilters(const PngLayout& layout, std::byte* filtered, std::byte* texels)
{
    const std::size_t channels = channelsOf(layout.colorType), pixelBytes = pixelBytesOf(layout);
    const std::size_t rowBytes = layout.width * pixelBytes, texelBytes = static_cast<std::size_t>(layout.width) *
                                                                         static_cast<std::size_t>(layout.bitDepth) / 2;
    const bool straight = layout.bitDepth == 8 && channels >= 3;
    std::vector<std::byte> before(std::max(rowBytes, texelBytes));
    if (straight && channels == 3)
        for (std::size_t i = 3; i < texelBytes; i += 4)
            before[i] = std::byte(255);
    const std::byte* above = before.data();
    for (std::uint32_t y = 0; y < layout.height; ++y, filtered += rowBytes + 1, texels += texelBytes) {
        if (std::to_integer<int>(*filtered) >= kPngFilters)
            return false;
        const auto filter = static_cast<PngFilter>(*filtered);
        std::byte* row = filtered + 1;
        if (straight) {
            undoPngFilterToRgba(filter, row, above, layout.width, channels, texels);
            above = texels;
            continue;
        }
        undoPngFilter(filter, row, above, rowBytes, pixelBytes);
        above = row;
        if (layout.colorType == 3)
            lookUp(row, layout.width, layout.palette, texels);
        else
            layout.bitDepth == 8 ? spread<1>(row, layout.width, layout.colorType, texels)
                                 : spread<2>(row, layout.width, layout.colorType, texels);
    }
    return true;
}

} // namespace

bool readPngTexels(const PngLayout& layout, std::span<const std::byte> chunks, DecodeScratch& scratch,
                   std::byte* texels)
{
    if (!isKnown(layout))
        return false;
    const std::size_t rowBytes = layout.width * pixelBytesOf(layout);
    const std::size_t size = (rowBytes + 1) * layout.height;
    std::byte* const filtered = scratch.filtered.atLeast(size);
    return inflateWhole(takeStream(chunks, scratch.compressed), filtered, size) &&
           undoFilters(layout, filtered, texels);
}

} // namespace torrance
