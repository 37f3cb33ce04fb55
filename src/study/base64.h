// Bytes as text.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace torrance {

/// RFC 4648, section 4: the standard alphabet, padded, without line breaks.
std::string base64(std::span<const std::byte> bytes);

} // namespace torrance
