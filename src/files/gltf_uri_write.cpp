#include "files/gltf_uri_write.h"

#include <cstdint>

namespace torrance {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHex = "0123456789ABCDEF";
constexpr std::string_view kBase64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

bool staysAsItIs(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
           std::string_view("-._~/").find(c) != std::string_view::npos;
}

} // namespace

std::string percentEncoded(std::string_view path)
{
    std::string uri;
    for (const char c : path) {
        const auto code = static_cast<unsigned char>(c);
        if (staysAsItIs(c))
            uri += c;
        else
            (uri += '%').append({kHex[code >> 4], kHex[code & 15]});
    }
    return uri;
}

std::string relativeUri(const fs::path& file, const fs::path& folder)
{
    const fs::path whole = fs::absolute(file);
    const fs::path place = fs::weakly_canonical(whole.parent_path()) / whole.filename();
    return percentEncoded(place.lexically_relative(fs::weakly_canonical(fs::absolute(folder))).generic_string());
}

bool leavesTheFolder(std::string_view relativeUri)
{
    return relativeUri == ".." || relativeUri.starts_with("../") || relativeUri.starts_with("/");
}

std::string dataUri(std::span<const std::byte> bytes, std::string_view mimeType)
{
    std::string uri = "data:" + std::string(mimeType) + ";base64,";
    uri.reserve(uri.size() + (bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k)
            uri += i + k <= bytes.size() ? kBase64[bits >> (18 - 6 * k) & 63] : '='; // k letters hold k - 1 bytes
    }
    return uri;
}

} // namespace torrance
