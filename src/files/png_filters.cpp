#include "files/png_filters.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace torrance {
namespace {

int number(std::byte value)
{
    return std::to_integer<int>(value);
}

int paeth(int left, int above, int aboveLeft)
{
    const int toLeft = std::abs(above - aboveLeft), toAbove = std::abs(left - aboveLeft);
    const int toAboveLeft = std::abs(left + above - 2 * aboveLeft);
    return toLeft <= toAbove && toLeft <= toAboveLeft ? left : toAbove <= toAboveLeft ? above : aboveLeft;
}

template <typename Predict>
void undo(std::byte* row, const std::byte* above, std::size_t rowBytes, std::size_t pixelBytes, const Predict& predict)
{
    for (std::size_t i = 0; i < rowBytes; ++i) {
        const bool first = i < pixelBytes;
        const int left = first ? 0 : number(row[i - pixelBytes]);
        const int aboveLeft = first ? 0 : number(above[i - pixelBytes]);
        row[i] = static_cast<std::byte>(number(row[i]) + predict(left, number(above[i]), aboveLeft));
    }
}

} // namespace

void undoPngFilter(PngFilter filter, std::byte* row, const std::byte* above, std::size_t rowBytes,
                   std::size_t pixelBytes)
{
    switch (filter) {
    case PngFilter::none:
        return;
    case PngFilter::sub:
        return undo(row, above, rowBytes, pixelBytes, [](int left, int, int) { return left; });
    case PngFilter::up:
        return undo(row, above, rowBytes, pixelBytes, [](int, int up, int) { return up; });
    case PngFilter::average:
        return undo(row, above, rowBytes, pixelBytes, [](int left, int up, int) { return (left + up) / 2; });
    case PngFilter::paeth:
        return undo(row, above, rowBytes, pixelBytes, paeth);
    }
}

#ifdef __SSE2__
namespace {

template <std::size_t kChannels>
__m128i loadPixel(const std::byte* at)
{
    std::uint32_t bits = 0;
    if (kChannels == 4) {
        std::memcpy(&bits, at, 4);
        return _mm_cvtsi32_si128(static_cast<int>(bits));
    }
    // Three bytes by two loads: the byte behind the last pixel is somebody else's.
    std::uint16_t low;
    std::memcpy(&low, at, 2);
    bits = low | std::to_integer<std::uint32_t>(at[2]) << 16;
    return _mm_cvtsi32_si128(static_cast<int>(bits));
}

void storePixel(std::byte* at, __m128i pixel)
{
    const int bits = _mm_cvtsi128_si32(pixel);
    std::memcpy(at, &bits, 4);
}

/// A pixel from its neighbours, in its lowest four bytes.
struct Average
{
    __m128i operator()(__m128i left, __m128i above, __m128i) const
    {
        // The instruction rounds up, the filter down.
        const __m128i odd = _mm_and_si128(_mm_xor_si128(left, above), _mm_set1_epi8(1));
        return _mm_sub_epi8(_mm_avg_epu8(left, above), odd);
    }
};

__m128i absolute(__m128i x) // of 16-bit numbers
{
    return _mm_max_epi16(x, _mm_sub_epi16(_mm_setzero_si128(), x));
}

__m128i chosen(__m128i mask, __m128i ifSet, __m128i otherwise)
{
    return _mm_or_si128(_mm_and_si128(mask, ifSet), _mm_andnot_si128(mask, otherwise));
}

/// Paeth's predictor of eight bytes, widened to 16 bits.
__m128i paeth(__m128i left, __m128i above, __m128i aboveLeft)
{
    const __m128i beside = _mm_sub_epi16(above, aboveLeft), over = _mm_sub_epi16(left, aboveLeft);
    const __m128i toLeft = absolute(beside), toAbove = absolute(over);
    const __m128i toAboveLeft = absolute(_mm_add_epi16(beside, over));
    const __m128i nearest = _mm_min_epi16(toAboveLeft, _mm_min_epi16(toLeft, toAbove));
    return chosen(_mm_cmpeq_epi16(nearest, toLeft), left, chosen(_mm_cmpeq_epi16(nearest, toAbove), above, aboveLeft));
}

struct Paeth
{
    __m128i operator()(__m128i left, __m128i above, __m128i aboveLeft) const
    {
        const auto wide = [](__m128i pixel) { return _mm_unpacklo_epi8(pixel, _mm_setzero_si128()); };
        const __m128i choice = paeth(wide(left), wide(above), wide(aboveLeft));
        return _mm_packus_epi16(choice, choice);
    }
};

__m128i load16(const std::uint8_t* at)
{
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
}

/// Paeth's predictor of sixteen bytes.
__m128i paethOf16(__m128i left, __m128i above, __m128i aboveLeft)
{
    const __m128i zero = _mm_setzero_si128();
    return _mm_packus_epi16(
        paeth(_mm_unpacklo_epi8(left, zero), _mm_unpacklo_epi8(above, zero), _mm_unpacklo_epi8(aboveLeft, zero)),
        paeth(_mm_unpackhi_epi8(left, zero), _mm_unpackhi_epi8(above, zero), _mm_unpackhi_epi8(aboveLeft, zero)));
}

template <std::size_t kChannels, typename Predict>
void undoToRgba(const std::byte* row, const std::byte* above, std::size_t pixels, std::byte* rgba,
                const Predict& predict)
{
    // Left of the first pixel lies black, as opaque as all others: an alpha that is not stored is 255 everywhere, and
    // every filter keeps it where nothing is added.
    const __m128i outside = _mm_cvtsi32_si128(kChannels == 4 ? 0 : static_cast<int>(0xff000000u));
    __m128i left = outside, aboveLeft = outside;
    for (std::size_t i = 0; i < pixels; ++i) {
        const __m128i up = loadPixel<4>(above + 4 * i);
        left = _mm_add_epi8(loadPixel<kChannels>(row + kChannels * i), predict(left, up, aboveLeft));
        aboveLeft = up;
        storePixel(rgba + 4 * i, left);
    }
}

template <std::size_t kChannels>
void undoToRgba(PngFilter filter, const std::byte* row, const std::byte* above, std::size_t pixels, std::byte* rgba)
{
    const __m128i nothing = _mm_cvtsi32_si128(kChannels == 4 ? 0 : static_cast<int>(0xff000000u));
    switch (filter) {
    case PngFilter::none:
        return undoToRgba<kChannels>(row, above, pixels, rgba, [=](__m128i, __m128i, __m128i) { return nothing; });
    case PngFilter::sub:
        return undoToRgba<kChannels>(row, above, pixels, rgba, [](__m128i left, __m128i, __m128i) { return left; });
    case PngFilter::up:
        return undoToRgba<kChannels>(row, above, pixels, rgba, [](__m128i, __m128i up, __m128i) { return up; });
    case PngFilter::average:
        return undoToRgba<kChannels>(row, above, pixels, rgba, Average());
    case PngFilter::paeth:
        return undoToRgba<kChannels>(row, above, pixels, rgba, Paeth());
    }
}

} // namespace

void undoPngFilterToRgba(PngFilter filter, const std::byte* row, const std::byte* above, std::size_t pixels,
                         std::size_t channels, std::byte* rgba)
{
    channels == 3 ? undoToRgba<3>(filter, row, above, pixels, rgba) : undoToRgba<4>(filter, row, above, pixels, rgba);
}

#else

void undoPngFilterToRgba(PngFilter filter, const std::byte* row, const std::byte* above, std::size_t pixels,
                         std::size_t channels, std::byte* rgba)
{
    for (std::size_t i = 0; i < pixels; ++i) {
        std::memcpy(rgba + 4 * i, row + channels * i, channels);
        if (channels == 3)
            rgba[4 * i + 3] = std::byte(0);
    }
    undoPngFilter(filter, rgba, above, 4 * pixels, 4);
    if (channels == 3)
        for (std::size_t i = 0; i < pixels; ++i)
            rgba[4 * i + 3] = std::byte(255);
}

#endif

void filterByPaeth(const std::uint8_t* row, const std::uint8_t* above, std::size_t rowBytes, std::size_t pixelBytes,
                   std::byte* filtered)
{
    std::size_t i = 0;
    for (; i < std::min(pixelBytes, rowBytes); ++i)
        filtered[i] = static_cast<std::byte>(row[i] - above[i]);
#ifdef __SSE2__
    for (; i + 16 <= rowBytes; i += 16) {
        const __m128i predicted =
            paethOf16(load16(row + i - pixelBytes), load16(above + i), load16(above + i - pixelBytes));
        _mm_storeu_si128(reinterpret_cast<__m128i*>(filtered + i), _mm_sub_epi8(load16(row + i), predicted));
    }
#endif
    for (; i < rowBytes; ++i)
        filtered[i] = static_cast<std::byte>(row[i] - paeth(row[i - pixelBytes], above[i], above[i - pixelBytes]));
}

} // namespace torrance
