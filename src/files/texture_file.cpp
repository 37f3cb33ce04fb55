#include "files/texture_file.h"

#include "core/error.h"
#include "files/texture_decoders.h"

#include <algorithm>
#include <string_view>

namespace torrance {
namespace {

using namespace std::string_view_literals;

enum class Kind
{
    png,
    jpeg,
    webp,
    unknown,
};

bool holdsAt(std::span<const std::byte> bytes, std::size_t offset, std::string_view text)
{
    const auto expected = std::as_bytes(std::span(text));
    return bytes.size() >= offset + text.size() &&
           std::equal(expected.begin(), expected.end(), bytes.begin() + static_cast<std::ptrdiff_t>(offset));
}

// The signatures: PNG specification 5.2, ITU T.81 B.1.1.3 (SOI and the next marker), WebP container specification.
Kind kindOf(std::span<const std::byte> bytes)
{
    if (holdsAt(bytes, 0, "\x89PNG\r\n\x1a\n"sv))
        return Kind::png;
    if (holdsAt(bytes, 0, "\xff\xd8\xff"sv))
        return Kind::jpeg;
    if (holdsAt(bytes, 0, "RIFF"sv) && holdsAt(bytes, 8, "WEBP"sv))
        return Kind::webp;
    return Kind::unknown;
}

} // namespace

void checkTextureSize(long long width, long long height, const TextureSource& source)
{
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    if (width <= 0 || height <= 0)
        throw inputError(source.file, source.name, "the image is " + size, "give it at least one texel");
    if (width > kMaxTextureSide || height > kMaxTextureSide || width * height > kMaxTextureTexels)
        throw inputError(source.file, source.name, "the image is " + size,
                         "shrink it to at most " + std::to_string(kMaxTextureSide) + " texels a side");
}

void throwCorrupt(const TextureSource& source, const std::string& problem)
{
    throw inputError(source.file, source.name, problem, "export the image again");
}

TextureImage decodeTexture(std::span<const std::byte> bytes, const std::string& name, const std::string& file)
{
    DecodeScratch scratch;
    return decodeTexture(bytes, name, file, scratch);
}

TextureImage decodeTexture(std::span<const std::byte> bytes, const std::string& name, const std::string& file,
                           DecodeScratch& scratch)
{
    const TextureSource source{name, file};
    if (bytes.empty())
        throwCorrupt(source, "the image is empty");
    switch (kindOf(bytes)) {
    case Kind::png:
        return decodePng(bytes, source, scratch);
    case Kind::jpeg:
        return decodeJpeg(bytes, source);
    case Kind::webp:
        return decodeWebp(bytes, source);
    case Kind::unknown:
        break;
    }
    throw inputError(file, name, "the image is neither PNG nor JPEG nor WebP", "convert it to PNG");
}

const char* textureMimeType(std::span<const std::byte> bytes)
{
    switch (kindOf(bytes)) {
    case Kind::png:
        return "image/png";
    case Kind::jpeg:
        return "image/jpeg";
    case Kind::webp:
        return "image/webp";
    case Kind::unknown:
        break;
    }
    return "";
}

bool isTexture(std::span<const std::byte> bytes)
{
    return kindOf(bytes) != Kind::unknown;
}

std::optional<ImageSize> textureSize(std::span<const std::byte> bytes)
{
    switch (kindOf(bytes)) {
    case Kind::png:
        return pngSize(bytes);
    case Kind::jpeg:
        return jpegSize(bytes);
    case Kind::webp:
        return webpSize(bytes);
    case Kind::unknown:
        break;
    }
    return std::nullopt;
}

} // namespace torrance
