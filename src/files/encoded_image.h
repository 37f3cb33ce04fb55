// Pictures on their way from files to texels.
#pragma once

#include "scene/texture.h"

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace torrance {

struct EncodedImage
{
    std::string file;               // that names it, for messages
    std::string name;               // within that file
    std::vector<std::byte> storage; // empty where `bytes` lie in somebody else's
    std::span<const std::byte> bytes;
};

/// An Error (input) where the pictures come to more than `maxTexelBytes` of texels: known from their headers, before
/// anything is decoded.
void checkTotalSize(const std::vector<EncodedImage>& images, std::uint64_t maxTexelBytes);

/// Decodes them on all cores. The error is that of the first image that has one, however the work was spread over
/// threads. Throws Cancelled where a stop was asked for, which is looked at before each image.
std::vector<TextureImage> decodeAll(const std::vector<EncodedImage>& encoded, const std::stop_token& stop = {});

} // namespace torrance
