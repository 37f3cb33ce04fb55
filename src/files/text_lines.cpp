#include "files/text_lines.h"

#include <charconv>
#include <limits>

namespace torrance {
namespace {

constexpr std::string_view kBlank = " \t";

/// A comment begins with a word: names of files may hold the sign.
std::string_view withoutComment(std::string_view line)
{
    for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
        if (at == 0 || kBlank.find(line[at - 1]) != std::string_view::npos)
            return line.substr(0, at);
    return line;
}

} // namespace

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(kBlank);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string_view takeWord(std::string_view& text)
{
    text = trimmed(text);
    const std::string_view word = text.substr(0, text.find_first_of(kBlank));
    text = trimmed(text.substr(word.size()));
    return word;
}

std::optional<double> numberOf(std::string_view word)
{
    if (word.starts_with('+'))
        word.remove_prefix(1);
    double number = 0.0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (word.empty() || end != word.data() + word.size())
        return std::nullopt;
    if (failure == std::errc::result_out_of_range)
        return word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos
                   ? 0.0
                   : std::numeric_limits<double>::infinity();
    return failure == std::errc() ? std::optional(number) : std::nullopt;
}

std::string_view TextLines::takeLine()
{
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    const std::string_view line = text.substr(at, end - at);
    at = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
    ++number;
    return line;
}

std::optional<TextLine> TextLines::next()
{
    while (at < text.size()) {
        std::string_view line = takeLine();
        const std::size_t first = number;
        if (line.ends_with('\\')) {
            joined.clear();
            for (; line.ends_with('\\'); line = at < text.size() ? takeLine() : std::string_view())
                joined.append(line.substr(0, line.size() - 1)).push_back(' ');
            joined.append(line);
            line = joined;
        }
        line = trimmed(withoutComment(line));
        if (!line.empty())
            return TextLine{first, line};
    }
    return std::nullopt;
}

} // namespace torrance
