// The filters of PNG, row by row (PNG specification, chapter 9).
#pragma once

#include <cstddef>
#include <cstdint>

namespace torrance {

enum class PngFilter : std::uint8_t
{
    none,
    sub,
    up,
    average,
    paeth,
};
inline constexpr int kPngFilters = 5;

/// Undoes the filter of a row in place. `above` is the row before, undone, or a row of zeros; `pixelBytes` is 1 to 8.
void undoPngFilter(PngFilter filter, std::byte* row, const std::byte* above, std::size_t rowBytes,
                   std::size_t pixelBytes);

/// The same for pixels of 8-bit RGB or RGBA (`channels` 3 or 4), which become RGBA with an alpha of 255 on the way.
/// `above` is of that form too: zeros with the alpha that the picture's has where it has none.
void undoPngFilterToRgba(PngFilter filter, const std::byte* row, const std::byte* above, std::size_t pixels,
                         std::size_t channels, std::byte* rgba);

/// The differences of a row to what Paeth's predictor makes of its neighbours. `above` is the row before, or zeros.
void filterByPaeth(const std::uint8_t* row, const std::uint8_t* above, std::size_t rowBytes, std::size_t pixelBytes,
                   std::byte* filtered);

} // namespace torrance
