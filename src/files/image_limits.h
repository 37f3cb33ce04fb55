// The largest pictures that are read into float.
#pragma once

#include <string>

namespace torrance {

/// Twice a 16k panorama's width.
inline constexpr int kMaxImageSide = 32768;
/// Floats of one picture, 2 GiB: a 16k x 8k panorama fits. A file of a few bytes may claim any size.
inline constexpr long long kMaxImageValues = 1LL << 29;

/// An Error (input) where a side is zero, or something is above the limits.
void checkImageSize(long long width, long long height, long long channels, const std::string& file);

} // namespace torrance
