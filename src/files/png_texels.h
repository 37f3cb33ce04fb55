// The texels of PNG files by a short way: the whole picture inflated at once, filters undone several bytes at a time.
// It is for files without fault or peculiarity; what libpng makes of any other is for libpng to say.
#pragma once

#include "files/decode_scratch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace torrance {

/// What stands before the first IDAT.
struct PngLayout
{
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int bitDepth = 8;
    int colorType = 6; // 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
    bool interlaced = false;
    bool hasKeyColor = false;                    // tRNS of a picture without palette
    std::array<std::uint32_t, 256> palette = {}; // RGBA as the texels have it, in memory's order
};

/// Decodes into `texels`, four channels of 8 or 16 bits in native order as TextureImage has them. `chunks` begins with
/// the first IDAT chunk and goes on to the end of the file. False, with `texels` half written, where the layout is not
/// one of 8 or 16 bits a channel without interlacing or key colour, where a chunk is damaged, out of order or not known
/// to be without effect, and where the stream is not what it should be in every respect.
bool readPngTexels(const PngLayout& layout, std::span<const std::byte> chunks, DecodeScratch& scratch,
                   std::byte* texels);

} // namespace torrance
