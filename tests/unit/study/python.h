// What a parser that somebody else wrote makes of a text of ours.
#pragma once

#include <string>
#include <string_view>

namespace torrance::test {

/// Standard output of python3 -c `script`, with `text` on its standard input. A failed test where it ends with an
/// error.
std::string python(std::string_view script, std::string_view text);

} // namespace torrance::test
