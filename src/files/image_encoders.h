// The encoders of display-referred pictures. Codes are of values encoded by a transfer curve; alpha is straight. The
// same codes give the same bytes, whatever the number of threads.
#pragma once

#include "image/code_rows.h"

#include <cstddef>
#include <vector>

namespace torrance {

/// 1 (grey), 3 or 4 channels; 8 or 16 bits a channel. Marked as sRGB.
std::vector<std::byte> encodePng(const CodeRows& rows);
/// Of values clipped to [0, 1] and rounded half to even.
std::vector<std::byte> encodePng(const Image& image, int bitsPerChannel);

/// 1 or 3 channels, 8 bits, colour at full resolution (4:4:4). Quality 1 to 100. An Error (usage) above 65500 texels a
/// side.
std::vector<std::byte> encodeJpeg(const CodeRows& rows, int quality);

/// 3 or 4 channels, 8 bits. Quality 1 to 99 is lossy, 100 lossless. An Error (usage) above 16383 texels a side.
std::vector<std::byte> encodeWebp(const CodeRows& rows, int quality);

} // namespace torrance
