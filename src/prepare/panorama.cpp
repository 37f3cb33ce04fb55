#include "prepare/panorama.h"

#include "core/parallel.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace torrance {
namespace {

constexpr std::size_t kRowsAtATime = 16;

using Color = float __attribute__((vector_size(4 * sizeof(float))));

/// Of a texel of three channels, with an alpha of 1. Reads the float after them.
Color opaque(const float* texel)
{
    Color color;
    std::memcpy(&color, texel, sizeof color);
    color[3] = 1.0f;
    return color;
}

/// The same of the last texel, which no float follows.
Color lastOpaque(const float* texel)
{
    return Color{texel[0], texel[1], texel[2], 1.0f};
}

Color colorOf(const float* texel)
{
    Color color;
    std::memcpy(&color, texel, sizeof color);
    return color;
}

void put(float* texel, const Color& color)
{
    std::memcpy(texel, &color, sizeof color);
}

/// `read` gives a texel's colour.
template <typename Read>
Image halved(const Image& fine, const Read& read)
{
    Image level(std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), 4);
    parallelFor(static_cast<std::size_t>(level.height), kRowsAtATime, [&](std::size_t row) {
        const int y = static_cast<int>(row), x1 = fine.width > 1 ? 1 : 0;
        const float* upper = fine.at(0, std::min(2 * y, fine.height - 1));
        const float* lower = fine.at(0, std::min(2 * y + 1, fine.height - 1));
        for (int x = 0; x < level.width; ++x) {
            const int left = fine.channels * 2 * x, right = left + fine.channels * x1;
            put(level.at(x, y),
                0.25f * (read(upper + left) + read(upper + right) + read(lower + left) + read(lower + right)));
        }
    });
    return level;
}

Image halfOfRadiance(const Image& radiance)
{
    const float* last = radiance.texels.data() + radiance.texels.size() - 3;
    return halved(radiance, [last](const float* texel) { return texel == last ? lastOpaque(texel) : opaque(texel); });
}

} // namespace

PanoramaTexels::PanoramaTexels(const Image& picture) : radiance(picture)
{
    assert(radiance.channels == 3);
    if (radiance.height > 1)
        halves.push_back(halfOfRadiance(radiance));
    while (!halves.empty() && halves.back().height > 1)
        halves.push_back(halved(halves.back(), colorOf));
}

void PanoramaTexels::next(std::span<float> rgba)
{
    const std::size_t ofLevel0 = radiance.texels.size() / 3;
    for (; at + 1 < ofLevel0 && !rgba.empty(); ++at, rgba = rgba.subspan(4))
        put(rgba.data(), opaque(radiance.texels.data() + 3 * at));
    if (at + 1 == ofLevel0 && !rgba.empty()) {
        put(rgba.data(), lastOpaque(radiance.texels.data() + 3 * at));
        ++at;
        rgba = rgba.subspan(4);
    }
    std::size_t first = ofLevel0; // of a level
    for (const Image& level : halves) {
        const std::size_t texels = level.texels.size() / 4;
        if (!rgba.empty() && at < first + texels) {
            const std::size_t count = std::min(rgba.size() / 4, first + texels - at);
            std::copy_n(level.texels.data() + 4 * (at - first), 4 * count, rgba.data());
            at += count;
            rgba = rgba.subspan(4 * count);
        }
        first += texels;
    }
    assert(rgba.empty());
}

} // namespace torrance
