#include "gpu/glsl_tokens.h"

#include <algorithm>
#include <cctype>

namespace torrance::gpu {
namespace {

bool isSpace(char c)
{
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool isDigit(char c)
{
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool isWordCharacter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool isHexadecimal(std::string_view number)
{
    return number.starts_with("0x") || number.starts_with("0X");
}

// Of the comment that `text` starts with.
std::size_t commentLength(std::string_view text)
{
    const bool line = text[1] == '/';
    const std::size_t end = text.find(line ? "\n" : "*/", 2);
    return end == std::string_view::npos ? text.size() : end + (line ? 0 : 2);
}

std::size_t numberLength(std::string_view text)
{
    std::size_t length = 0;
    while (length < text.size()) {
        const char c = text[length];
        const bool exponentSign = (c == '+' || c == '-') && length > 0 && !isHexadecimal(text) &&
                                  (text[length - 1] == 'e' || text[length - 1] == 'E');
        if (!isWordCharacter(c) && c != '.' && !exponentSign)
            break;
        ++length;
    }
    return length;
}

std::size_t blankLength(std::string_view text)
{
    return static_cast<std::size_t>(std::ranges::find_if_not(text, isSpace) - text.begin());
}

std::size_t wordLength(std::string_view text)
{
    return static_cast<std::size_t>(std::ranges::find_if_not(text, isWordCharacter) - text.begin());
}

std::size_t quotedLength(std::string_view text)
{
    const std::size_t end = text.find('"', 1);
    return end == std::string_view::npos ? text.size() : end + 1;
}

GlslToken first(std::string_view text)
{
    using Kind = GlslToken::Kind;
    const char c = text[0], next = text.size() > 1 ? text[1] : '\0';
    if (isSpace(c))
        return {Kind::blank, text.substr(0, blankLength(text))};
    if (c == '/' && (next == '/' || next == '*'))
        return {Kind::blank, text.substr(0, commentLength(text))};
    if (isDigit(c) || (c == '.' && isDigit(next)))
        return {Kind::number, text.substr(0, numberLength(text))};
    if (isWordCharacter(c))
        return {Kind::word, text.substr(0, wordLength(text))};
    return {Kind::punctuation, text.substr(0, c == '"' ? quotedLength(text) : 1)};
}

} // namespace

std::vector<GlslToken> glslTokens(std::string_view text)
{
    std::vector<GlslToken> tokens;
    while (!text.empty()) {
        tokens.push_back(first(text));
        text.remove_prefix(tokens.back().text.size());
    }
    return tokens;
}

bool isFloatLiteral(std::string_view number)
{
    return !isHexadecimal(number) && number.find_first_of(".eEfF") != std::string_view::npos;
}

} // namespace torrance::gpu
