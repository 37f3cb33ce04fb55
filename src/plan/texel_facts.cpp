#include "plan/texel_facts.h"

#include "core/parallel.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace torrance {
namespace {

template <typename Channel>
struct Range
{
    std::array<Channel, 4> least, greatest;
};

template <typename Channel>
Range<Channel> rangeOfRow(const std::byte* row, int width)
{
    Range<Channel> range;
    range.least.fill(std::numeric_limits<Channel>::max());
    range.greatest.fill(0);
    for (int x = 0; x < width; ++x) {
        std::array<Channel, 4> texel;
        std::memcpy(texel.data(), row + static_cast<std::size_t>(x) * sizeof texel, sizeof texel);
        for (std::size_t c = 0; c < 4; ++c) {
            range.least[c] = std::min(range.least[c], texel[c]);
            range.greatest[c] = std::max(range.greatest[c], texel[c]);
        }
    }
    return range;
}

template <typename Channel>
TexelFacts factsOf(const TextureImage& image)
{
    std::vector<Range<Channel>> rows(static_cast<std::size_t>(image.height));
    const std::size_t rowBytes = static_cast<std::size_t>(image.width) * bytesPerTexel(image.format);
    constexpr std::size_t kRowsAtATime = 64;
    parallelFor(rows.size(), kRowsAtATime,
                [&](std::size_t y) { rows[y] = rangeOfRow<Channel>(image.texels.data() + y * rowBytes, image.width); });
    constexpr double kFull = std::numeric_limits<Channel>::max();
    TexelFacts facts;
    for (std::size_t c = 0; c < 4; ++c) {
        Channel least = std::numeric_limits<Channel>::max(), greatest = 0;
        for (const Range<Channel>& row : rows) {
            least = std::min(least, row.least[c]);
            greatest = std::max(greatest, row.greatest[c]);
        }
        facts.least[c] = least / kFull;
        facts.greatest[c] = greatest / kFull;
    }
    return facts;
}

} // namespace

TexelFacts texelFacts(const TextureImage& image)
{
    return image.format == TexelFormat::rgba8 ? factsOf<std::uint8_t>(image) : factsOf<std::uint16_t>(image);
}

} // namespace torrance
