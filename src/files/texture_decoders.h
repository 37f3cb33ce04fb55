// The decoders behind decodeTexture, one per kind of file.
#pragma once

#include "files/decode_scratch.h"
#include "files/texture_file.h"

namespace torrance {

/// Who a message is about.
struct TextureSource
{
    const std::string& name;
    const std::string& file;
};

/// Throws where the size is zero or above kMaxTextureSide or kMaxTextureTexels.
void checkTextureSize(long long width, long long height, const TextureSource& source);
[[noreturn]] void throwCorrupt(const TextureSource& source, const std::string& problem);

TextureImage decodePng(std::span<const std::byte> bytes, const TextureSource& source, DecodeScratch& scratch);
TextureImage decodeJpeg(std::span<const std::byte> bytes, const TextureSource& source);
TextureImage decodeWebp(std::span<const std::byte> bytes, const TextureSource& source);

std::optional<ImageSize> pngSize(std::span<const std::byte> bytes);
std::optional<ImageSize> jpegSize(std::span<const std::byte> bytes);
std::optional<ImageSize> webpSize(std::span<const std::byte> bytes);

} // namespace torrance
