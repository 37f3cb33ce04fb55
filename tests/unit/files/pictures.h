// Small pictures made from their codes.
#pragma once

#include "png_bytes.h"
#include "scene/texture.h"

#include <cstring>
#include <initializer_list>

namespace torrance::test {

/// Four channels from the codes given.
inline TextureImage picture8(int width, int height, std::initializer_list<int> codes)
{
    TextureImage image{"picture", width, height, TexelFormat::rgba8, {}};
    for (const int code : codes)
        image.texels.push_back(static_cast<std::byte>(code));
    return image;
}

inline TextureImage grey8(int width, int height, std::initializer_list<int> codes)
{
    TextureImage image{"grey", width, height, TexelFormat::rgba8, {}};
    for (const int code : codes)
        for (const int channel : {code, code, code, 255})
            image.texels.push_back(static_cast<std::byte>(channel));
    return image;
}

inline TextureImage grey16(int width, int height, std::initializer_list<int> codes)
{
    TextureImage image{"grey", width, height, TexelFormat::rgba16, {}};
    for (const int code : codes)
        for (const int channel : {code, code, code, 65535}) {
            const auto value = static_cast<std::uint16_t>(channel);
            image.texels.resize(image.texels.size() + sizeof value);
            std::memcpy(image.texels.data() + image.texels.size() - sizeof value, &value, sizeof value);
        }
    return image;
}

/// A PNG file of one row, grey of 8 or 16 bits or RGB or RGBA of 8, from its codes.
inline std::string pngRow(int colorType, int bitDepth, std::initializer_list<int> codes)
{
    const int channels = colorType == 0 ? 1 : colorType == 2 ? 3 : 4;
    PngSpec spec;
    spec.width = static_cast<std::uint32_t>(codes.size()) / static_cast<std::uint32_t>(channels);
    spec.colorType = colorType;
    spec.bitDepth = bitDepth;
    spec.scanlines = {0};
    for (const int code : codes) {
        if (bitDepth == 16)
            spec.scanlines.push_back(static_cast<std::uint8_t>(code >> 8));
        spec.scanlines.push_back(static_cast<std::uint8_t>(code & 255));
    }
    return pngBytes(spec);
}

} // namespace torrance::test
