// Text made safe for HTML and XML.
#pragma once

#include <string>
#include <string_view>

namespace torrance {

/// `text` as content or as a quoted attribute of HTML and of XML 1.0: the characters & < > " ' as references, tab and
/// line break too (a parser would turn them into spaces in an attribute). What neither format can hold becomes U+FFFD:
/// bytes that are not UTF-8, other control characters, surrogates and noncharacters.
std::string markupEscaped(std::string_view text);

} // namespace torrance
