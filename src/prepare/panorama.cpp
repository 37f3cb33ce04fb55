#include "prepare/panorama.h"

#include "core/parallel.h"

#include <algorithm>

namespace torrance {
namespace {

constexpr std::size_t kRowsAtATime = 16;

Image withAlpha(const Image& radiance)
{
    Image level(radiance.width, radiance.height, 4, 1.0f);
    parallelFor(static_cast<std::size_t>(radiance.height), kRowsAtATime, [&](std::size_t y) {
        for (int x = 0; x < radiance.width; ++x)
            std::copy_n(radiance.at(x, static_cast<int>(y)), 3, level.at(x, static_cast<int>(y)));
    });
    return level;
}

Image halved(const Image& fine)
{
    Image level(std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), 4);
    parallelFor(static_cast<std::size_t>(level.height), kRowsAtATime, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        const int y0 = std::min(2 * y, fine.height - 1), y1 = std::min(2 * y + 1, fine.height - 1);
        for (int x = 0; x < level.width; ++x) {
            const int x0 = std::min(2 * x, fine.width - 1), x1 = std::min(2 * x + 1, fine.width - 1);
            for (int c = 0; c < 4; ++c)
                level.at(x, y)[c] =
                    0.25f * (fine.at(x0, y0)[c] + fine.at(x1, y0)[c] + fine.at(x0, y1)[c] + fine.at(x1, y1)[c]);
        }
    });
    return level;
}

} // namespace

std::vector<Image> panoramaLevels(const Image& radiance)
{
    std::vector<Image> levels = {withAlpha(radiance)};
    while (levels.back().height > 1)
        levels.push_back(halved(levels.back()));
    return levels;
}

} // namespace torrance
