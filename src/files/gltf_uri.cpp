#include "files/gltf_uri.h"

#include "core/error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

namespace torrance {
namespace {

/// URIs are quoted in messages, and searched for a scheme, up to this length: a data URI can have megabytes.
constexpr std::size_t kQuotedLength = 120;

int hexDigit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    const char lower = static_cast<char>(c | 0x20);
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

constexpr std::array<std::int8_t, 256> base64Values()
{
    std::array<std::int8_t, 256> values{};
    values.fill(-1);
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < kLetters.size(); ++i)
        values[static_cast<unsigned char>(kLetters[i])] = static_cast<std::int8_t>(i);
    values['-'] = 62; // the URL-safe alphabet of RFC 4648, section 5
    values['_'] = 63;
    return values;
}

std::optional<std::vector<std::byte>> base64Decoded(std::string_view text)
{
    static constexpr std::array<std::int8_t, 256> kValues = base64Values();
    while (!text.empty() && text.back() == '=')
        text.remove_suffix(1);
    if (text.size() % 4 == 1) // six bits are no byte
        return std::nullopt;
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char letter : text) {
        const int value = kValues[static_cast<unsigned char>(letter)];
        if (value < 0)
            return std::nullopt;
        bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xffffff;
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::byte>(bits >> count));
        }
    }
    return bytes;
}

/// RFC 3986, section 3.1: a letter, then letters, digits, + - and dots, then a colon. Empty where there is none.
std::string schemeOf(std::string_view uri)
{
    const std::size_t colon = uri.find(':');
    if (colon == std::string_view::npos || colon == 0 || !std::isalpha(static_cast<unsigned char>(uri[0])))
        return "";
    std::string scheme;
    for (const char c : uri.substr(0, colon)) {
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '+' && c != '-' && c != '.')
            return "";
        scheme += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return scheme;
}

bool leavesFolder(const std::string& path)
{
    if (path.starts_with('/'))
        return true;
    for (std::size_t start = 0; start <= path.size();) {
        const std::size_t end = std::min(path.find('/', start), path.size());
        if (path.compare(start, end - start, "..") == 0)
            return true;
        start = end + 1;
    }
    return false;
}

std::string quoted(std::string_view uri)
{
    const bool whole = uri.size() <= kQuotedLength;
    return "\"" + std::string(uri.substr(0, kQuotedLength)) + (whole ? "\"" : "...\"");
}

std::string withoutScheme(std::string_view uri, const std::string& scheme)
{
    std::string_view path = uri.substr(scheme.size() + 1);
    if (path.starts_with("//")) // file://host/path with an empty or a local host
        path.remove_prefix(std::min(path.find('/', 2), path.size()));
    return std::string(path);
}

} // namespace

std::string percentDecoded(std::string_view text)
{
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escape =
            text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0;
        decoded += escape ? static_cast<char>(hexDigit(text[i + 1]) * 16 + hexDigit(text[i + 2])) : text[i];
        i += escape ? 2 : 0;
    }
    return decoded;
}

bool isRelativeUri(std::string_view uri)
{
    return !uri.starts_with('/') && schemeOf(uri.substr(0, kQuotedLength)).empty();
}

std::optional<std::vector<std::byte>> dataOfUri(std::string_view uri, const std::string& file, const std::string& item)
{
    if (schemeOf(uri.substr(0, 5)) != "data") // "data:", in any case of letters
        return std::nullopt;
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos)
        throw inputError(file, item, "its data URI has no comma", "export the file again");
    const std::string_view content = uri.substr(comma + 1);
    if (!uri.substr(0, comma).ends_with(";base64")) {
        const std::string decoded = percentDecoded(content);
        const auto* first = reinterpret_cast<const std::byte*>(decoded.data());
        return std::vector<std::byte>(first, first + decoded.size());
    }
    auto bytes =
        content.find('%') == std::string_view::npos ? base64Decoded(content) : base64Decoded(percentDecoded(content));
    if (!bytes)
        throw inputError(file, item, "the base64 of its data URI is damaged", "export the file again");
    return bytes;
}

std::filesystem::path pathOfUri(std::string_view uri, const std::filesystem::path& folder, bool allowExternal,
                                const std::string& file, const std::string& item)
{
    const std::string scheme = schemeOf(uri);
    if (!scheme.empty() && !(allowExternal && scheme == "file"))
        throw inputError(file, item, "refers to " + quoted(uri) + ", a URI with a scheme",
                         scheme == "file" ? "put the file beside the model, or give --allow-external"
                                          : "download the file and put it beside the model");
    std::string path = percentDecoded(scheme.empty() ? std::string(uri) : withoutScheme(uri, scheme));
    if (!allowExternal)
        std::replace(path.begin(), path.end(), '\\', '/');
    if (path.empty() || path.find('\0') != std::string::npos)
        throw inputError(file, item, "has the URI " + quoted(uri) + ", which names no file", "export the file again");
    if (!allowExternal && leavesFolder(path))
        throw inputError(file, item, "refers to " + quoted(uri) + ", outside the folder of the model",
                         "put the file beside the model, or give --allow-external");
    return folder / path;
}

} // namespace torrance
