// The code values of a picture that is about to be stored, row by row as somebody asks for them: they need not all be
// in memory at once.
#pragma once

#include "image/display.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace torrance {

struct CodeRows
{
    int width = 0;
    int height = 0;
    int channels = 0;
    int bits = 8; // or 16
    /// Writes row y, from any thread. Numbers of 16 bits have their high byte first, as PNG has them.
    std::function<void(int y, std::uint8_t* codes)> row;

    std::size_t rowBytes() const
    {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels * bits / 8);
    }
};

/// quantized() of every value, in their order. `image` is looked at later.
CodeRows quantizedRows(const Image& image, int bits);

/// quantizedRows() of toDisplay(). `sceneLinear` is looked at later.
CodeRows displayRows(const Image& sceneLinear, const DisplaySettings& settings, int bits);

/// All rows, one after the other.
std::vector<std::uint8_t> allCodes(const CodeRows& rows);

} // namespace torrance
