#include "study/markup.h"

#include <array>
#include <cstdint>

namespace torrance {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD"; // U+FFFD

struct Character
{
    std::uint32_t code = 0;
    std::size_t bytes = 1;
    bool valid = false;
};

/// The character that `text` begins with. RFC 3629, section 4: the shortest form only, no surrogates, up to U+10FFFF.
Character firstCharacter(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
    if (byte(0) < 0x80)
        return {byte(0), 1, true};
    const std::size_t bytes = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000}; // of a form of so many bytes
    if (byte(0) < 0xC0 || byte(0) >= 0xF8 || text.size() < bytes)
        return {};
    std::uint32_t code = byte(0) & (0x7Fu >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0u) != 0x80u)
            return {};
        code = code << 6u | (byte(i) & 0x3Fu);
    }
    const bool surrogate = code >= 0xD800 && code < 0xE000;
    if (code < kLeast[bytes] || code > 0x10FFFF || surrogate)
        return {};
    return {code, bytes, true};
}

/// Neither a control character nor one of Unicode's noncharacters: HTML forbids both, XML most of them.
bool isText(std::uint32_t code)
{
    const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
    const bool noncharacter = (code & 0xFFFEu) == 0xFFFEu || (code >= 0xFDD0 && code < 0xFDF0);
    return !control && !noncharacter;
}

std::string_view reference(std::uint32_t code)
{
    switch (code) {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    case '\t':
        return "&#9;";
    case '\n':
        return "&#10;";
    default:
        return {};
    }
}

} // namespace

std::string markupEscaped(std::string_view text)
{
    std::string escaped;
    while (!text.empty()) {
        const Character c = firstCharacter(text);
        if (const std::string_view name = reference(c.code); c.valid && !name.empty())
            escaped += name;
        else
            escaped += c.valid && isText(c.code) ? text.substr(0, c.bytes) : kReplacement;
        text.remove_prefix(c.bytes);
    }
    return escaped;
}

} // namespace torrance
