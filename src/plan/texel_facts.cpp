#include "plan/texel_facts.h"

#include "core/parallel.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace torrance {
namespace {

using Bytes16 = std::uint8_t __attribute__((vector_size(16)));
using Words8 = std::uint16_t __attribute__((vector_size(16)));

/// Least and greatest numbers of as many texels as fit into 16 bytes, side by side.
template <typename Channel>
struct Range
{
    using Lanes = std::conditional_t<sizeof(Channel) == 1, Bytes16, Words8>;
    Lanes least = Lanes{} + std::numeric_limits<Channel>::max();
    Lanes greatest = Lanes{};

    void include(const std::byte* texels)
    {
        Lanes values;
        std::memcpy(&values, texels, sizeof values);
        include({values, values});
    }
    void include(const Range& other)
    {
        least = other.least < least ? other.least : least;
        greatest = other.greatest > greatest ? other.greatest : greatest;
    }
};

/// Of whole texels. The last bytes may be looked at twice, which changes nothing; too few are repeated.
template <typename Channel>
Range<Channel> rangeOf(std::span<const std::byte> texels)
{
    Range<Channel> range;
    constexpr std::size_t kStep = sizeof range.least;
    if (texels.size() < kStep) {
        std::byte repeated[kStep];
        for (std::size_t i = 0; i < kStep; ++i)
            repeated[i] = texels[i % texels.size()];
        range.include(repeated);
        return range;
    }
    for (std::size_t i = 0; i + kStep <= texels.size(); i += kStep)
        range.include(texels.data() + i);
    range.include(texels.data() + texels.size() - kStep);
    return range;
}

template <typename Channel>
TexelFacts factsOf(const TextureImage& image)
{
    constexpr std::size_t kBytesPerTask = 1u << 20;
    const std::span<const std::byte> texels = image.texels;
    std::vector<Range<Channel>> ranges((texels.size() + kBytesPerTask - 1) / kBytesPerTask);
    parallelFor(ranges.size(), 1, [&](std::size_t i) {
        const std::size_t first = i * kBytesPerTask;
        ranges[i] = rangeOf<Channel>(texels.subspan(first, std::min(kBytesPerTask, texels.size() - first)));
    });
    Range<Channel> all;
    for (const Range<Channel>& range : ranges)
        all.include(range);
    constexpr double kFull = std::numeric_limits<Channel>::max();
    TexelFacts facts;
    facts.least.fill(1.0);
    facts.greatest.fill(0.0);
    for (std::size_t lane = 0; lane < sizeof all.least / sizeof(Channel); ++lane) {
        facts.least[lane % 4] = std::min(facts.least[lane % 4], all.least[lane] / kFull);
        facts.greatest[lane % 4] = std::max(facts.greatest[lane % 4], all.greatest[lane] / kFull);
    }
    return facts;
}

} // namespace

TexelFacts texelFacts(const TextureImage& image)
{
    assert(!image.texels.empty());
    return image.format == TexelFormat::rgba8 ? factsOf<std::uint8_t>(image) : factsOf<std::uint16_t>(image);
}

std::vector<TexelFacts> texelFacts(const Scene& scene)
{
    std::vector<TexelFacts> facts;
    for (const TextureImage& image : scene.images)
        facts.push_back(texelFacts(image));
    return facts;
}

} // namespace torrance
