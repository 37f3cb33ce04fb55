#include "view/thumbnails.h"

#include "view/panel_renderer.h"
#include "view/pixels_under.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace torrance {
namespace {

constexpr int kSide = 64; // pixels of the longer side

// The mean of the codes under each pixel; data is seen as it stands in the file.
std::vector<std::uint8_t> shrunk(const TextureImage& image, int width, int height)
{
    const bool deep = image.format == TexelFormat::rgba16;
    std::vector<std::uint8_t> codes(std::size_t(width) * std::size_t(height) * 4);
    const auto codeAt = [&](std::size_t i) {
        if (!deep)
            return static_cast<unsigned>(image.texels[i]);
        std::uint16_t value = 0;
        std::memcpy(&value, image.texels.data() + 2 * i, 2);
        return unsigned(value) >> 8;
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const PixelBox under = pixelsUnder(x, y, {width, height}, {image.width, image.height});
            unsigned long sums[4] = {};
            for (int v = under.first.y; v < under.beyond.y; ++v)
                for (int u = under.first.x; u < under.beyond.x; ++u)
                    for (std::size_t c = 0; c < 4; ++c)
                        sums[c] += codeAt((std::size_t(v) * std::size_t(image.width) + std::size_t(u)) * 4 + c);
            const ivec2 sides = under.beyond - under.first;
            const auto count = static_cast<unsigned long>(sides.x) * static_cast<unsigned long>(sides.y);
            std::uint8_t* texel = codes.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4;
            for (std::size_t c = 0; c < 3; ++c)
                texel[c] = static_cast<std::uint8_t>(sums[c] / count);
            texel[3] = 255; // a mask in alpha would hide the colours below it
        }
    return codes;
}

} // namespace

const gpu::DeviceImage* Thumbnails::get(const Scene& scene, int index)
{
    const TextureImage& image = scene.images[static_cast<std::size_t>(index)];
    if (image.texels.empty())
        return nullptr;
    if (const auto found = pictures.find(index); found != pictures.end())
        return &found->second;
    const int longer = std::max(image.width, image.height);
    const int width = std::max(image.width * kSide / longer, 1), height = std::max(image.height * kSide / longer, 1);
    const std::vector<std::uint8_t> codes = shrunk(image, width, height);
    return &pictures
                .emplace(index, uploadPanelPicture(device, width, height, std::as_bytes(std::span(codes)), "thumbnail"))
                .first->second;
}

} // namespace torrance
