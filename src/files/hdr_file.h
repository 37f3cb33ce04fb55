// Radiance pictures (.hdr): 8-bit mantissas with a shared exponent. Ward, Real Pixels, Graphics Gems II, 1991, and the
// file format reference of Radiance.
#pragma once

#include "image/image.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace torrance {

/// Whether the bytes start as such a file does.
bool isHdr(std::span<const std::byte> bytes);

/// Three channels, radiance: mantissa * 2^(exponent - 136), divided by the file's EXPOSURE and COLORCORR, which say
/// what the stored values were multiplied with. All eight orientations, flat, old and new run-length coding. An Error
/// (input) where the file is truncated, corrupt, stores XYZE or is larger than the limits of image_limits.h.
Image decodeHdr(std::span<const std::byte> bytes, const std::string& file);

/// The first three channels of `image` (one is repeated) in new run-length coding. Mantissas are rounded to nearest, so
/// that a channel is within 1/256 of the pixel's largest (1/512 as a rule; the wider bound where that is nearly a power
/// of two). NaN and negative become 0; what lies above the format's range its largest value.
std::vector<std::byte> encodeHdr(const Image& image);

} // namespace torrance
