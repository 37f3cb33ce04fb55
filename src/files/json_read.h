// JSON text to a tree of values, with limits on what a hostile text can ask for.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace torrance {

/// Deeper nesting is refused: whoever walks the tree by recursion stays far from the end of the stack. Real files
/// nest about ten deep.
inline constexpr int kMaxJsonDepth = 128;

/// More values than this are refused. A value takes 16 to 120 bytes in memory, so that a text of a few megabytes cannot
/// ask for the whole machine; the largest public scenes hold under a million.
inline constexpr std::size_t kMaxJsonValues = std::size_t(1) << 23;

/// Errors (input) give the place in the tree ("/nodes/3/matrix/12"): malformed text, invalid UTF-8, a number that
/// overflows a double, a name given twice in one object, too deep, more than `mostValues` values.
nlohmann::json readJson(std::string_view text, const std::string& file, std::size_t mostValues = kMaxJsonValues);

} // namespace torrance
