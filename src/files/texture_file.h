// The pictures of a material: PNG, JPEG and WebP as they lie in a file or in a glTF buffer.
#pragma once

#include "files/decode_scratch.h"
#include "scene/texture.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace torrance {

/// Widest and highest picture that is read: what Vulkan implementations, lavapipe too, take for a 2D image.
inline constexpr int kMaxTextureSide = 16384;
/// Most texels of one picture: 1 GiB of rgba8. A file of a few bytes may claim any size.
inline constexpr long long kMaxTextureTexels = 1LL << 28;

struct ImageSize
{
    int width = 0;
    int height = 0;
};

/// Decodes a whole PNG, JPEG or WebP file in memory; the kind is told by its first bytes. The texels are the stored
/// code values: gAMA, cHRM, sRGB chunks and ICC profiles are ignored, as glTF 2.0 section 3.9.2 asks. 16-bit PNGs give
/// rgba16. `name` names the picture and `file` what holds it, for messages. An Error (input) where the bytes are
/// corrupt or truncated, of another kind, 0x0 or larger than the limits above: never half a picture.
TextureImage decodeTexture(std::span<const std::byte> bytes, const std::string& name, const std::string& file);
/// The same for one of many.
TextureImage decodeTexture(std::span<const std::byte> bytes, const std::string& name, const std::string& file,
                           DecodeScratch& scratch);

/// Whether the bytes start as PNG, JPEG or WebP do.
bool isTexture(std::span<const std::byte> bytes);

/// "image/png", "image/jpeg" or "image/webp", by the first bytes; "" where they are none of these.
const char* textureMimeType(std::span<const std::byte> bytes);

/// The size that the header claims, or nothing where there is no readable header.
std::optional<ImageSize> textureSize(std::span<const std::byte> bytes);

} // namespace torrance
