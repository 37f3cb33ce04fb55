// Results on standard output.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace torrance {

/// Writes all of it and flushes; an Error (cannotWrite) where that fails, as on a full disk.
void writeStandardOutput(std::span<const std::byte> bytes);
void writeStandardOutput(std::string_view text);

} // namespace torrance
