// The lines of a Wavefront file: one statement each.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace torrance {

struct TextLine
{
    std::size_t number = 0; // from 1, of its first line in the file
    std::string_view text;  // without comment and spaces at both ends; valid until the next one is read
};

/// Line after line of `text`, whatever its line ends (LF, CRLF, CR). Empty lines and comments (#) are passed over; a
/// line that ends in a backslash goes on in the next one.
class TextLines
{
public:
    explicit TextLines(std::string_view whole) : text(whole) {}

    std::optional<TextLine> next();

private:
    std::string_view takeLine();

    std::string_view text;
    std::size_t at = 0;
    std::size_t number = 0; // of the line taken last
    std::string joined;     // of a statement on several lines
};

/// The first word of `text`, which is then what follows it: spaces at both ends are gone.
std::string_view takeWord(std::string_view& text);

/// `text` without spaces and tabs at both ends.
std::string_view trimmed(std::string_view text);

/// The whole of `word` as a number; infinite where it is too large for a double, 0 where it is too small. Takes `nan`
/// and `inf` as well. Nothing where it is no number.
std::optional<double> numberOf(std::string_view word);

} // namespace torrance
