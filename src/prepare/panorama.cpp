#include "prepare/panorama.h"

#include "core/parallel.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace torrance {
namespace {

constexpr std::size_t kRowsAtATime = 16;

using Color = float __attribute__((vector_size(4 * sizeof(float))));

/// With an alpha of 1 where the picture has none.
Color colorAt(const float* texel, int channels)
{
    Color color = {0.0f, 0.0f, 0.0f, 1.0f};
    std::memcpy(&color, texel, static_cast<std::size_t>(channels) * sizeof(float));
    return color;
}

template <int channels>
Image halved(const Image& fine)
{
    Image level(std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), 4);
    parallelFor(static_cast<std::size_t>(level.height), kRowsAtATime, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        const float* upper = fine.at(0, std::min(2 * y, fine.height - 1));
        const float* lower = fine.at(0, std::min(2 * y + 1, fine.height - 1));
        float* out = level.at(0, y);
        for (int x = 0; x < level.width; ++x) {
            const int x0 = channels * std::min(2 * x, fine.width - 1);
            const int x1 = channels * std::min(2 * x + 1, fine.width - 1);
            const Color mean = 0.25f * (colorAt(upper + x0, channels) + colorAt(upper + x1, channels) +
                                        colorAt(lower + x0, channels) + colorAt(lower + x1, channels));
            std::memcpy(out + 4 * x, &mean, sizeof mean);
        }
    });
    return level;
}

} // namespace

PanoramaTexels::PanoramaTexels(const Image& picture) : radiance(picture)
{
    assert(radiance.channels == 3);
    if (radiance.height > 1)
        halves.push_back(halved<3>(radiance));
    while (!halves.empty() && halves.back().height > 1)
        halves.push_back(halved<4>(halves.back()));
}

void PanoramaTexels::next(std::span<float> rgba)
{
    const std::size_t ofLevel0 = radiance.texels.size() / 3;
    for (; at < ofLevel0 && !rgba.empty(); ++at, rgba = rgba.subspan(4)) {
        const Color color = colorAt(radiance.texels.data() + 3 * at, 3);
        std::memcpy(rgba.data(), &color, sizeof color);
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
