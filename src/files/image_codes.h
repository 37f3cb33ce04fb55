// The code values of a picture that is about to be stored.
#pragma once

#include "image/image.h"

#include <cstdint>
#include <vector>

namespace torrance {

/// quantized() of every value, in their order.
std::vector<std::uint8_t> codes8(const Image& image);
/// Two bytes each, the high one first, as PNG has them.
std::vector<std::uint8_t> codes16(const Image& image);

} // namespace torrance
